#!/usr/bin/env python3
"""Writes the three profiles beside this script, the same bytes every time.

They are made, not recorded: what the receivers of a scene see of the lights that each is called
after. Points are those of the R2 sequence (Roberts), mapped to the ranges below.

broad   a broad area light: lambda 1 to 20, logarithmic; cosines over the whole range, receivers
        that face the light more often than others, weight (1 + cos_theta)/2 and a tenth more
sharp   many sharp lights: lambda 100 to 3000, logarithmic, any cosine alike, weighted as small
        lights are where there are many, by 1/sqrt(lambda/100)
sky     the sky: lambda 0.1 to 3, logarithmic; axis upwards, receivers mostly floors and walls:
        cosines from -0.2 to 1, weight 1 at the ground and a quarter at the overhang
"""
import os

GOLDEN = 1.32471795724474602596
ROWS = 384


def write(name, low, high, cosine, weight):
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), name + ".csv")
    with open(path, "w", newline="\n") as out:
        out.write("lambda,cos_theta,weight\n")
        for i in range(ROWS):
            u, v = (0.5 + (i + 1) / GOLDEN) % 1.0, (0.5 + (i + 1) / GOLDEN**2) % 1.0
            sharpness, z = low * (high / low) ** u, cosine(v)
            out.write("%.6g,%.6f,%.6g\n" % (sharpness, z, weight(sharpness, z)))


write("broad", 1.0, 20.0, lambda v: 2.0 * v - 1.0, lambda s, z: 0.5 * (1.0 + z) + 0.1)
write("sharp", 100.0, 3000.0, lambda v: 2.0 * v - 1.0, lambda s, z: (s / 100.0) ** -0.5)
write("sky", 0.1, 3.0, lambda v: 1.2 * v - 0.2, lambda s, z: 0.25 + 0.75 * max(z, 0.0))
