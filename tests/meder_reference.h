/* meder_reference.h: the stages of the pipeline `meder` in C, in double where they calculate. */
#ifndef MEDER_REFERENCE_H
#define MEDER_REFERENCE_H

#include "render/internal.h"
#include "render/meder.h"

typedef struct reference {
    float depth[MEDER_SIDE * MEDER_SIDE];
    uint32_t labels[MEDER_SIDE * MEDER_SIDE];
    uint32_t count;
    meder_box *boxes; /* tile after tile, by label */
} reference;

/* Downsampling, Algorithm 1 and bounding boxes, from depth of the given size. The structure is
 * large: not for the stack. */
void reference_segment(reference *r, const float *depth, uint32_t width, uint32_t height,
                       float threshold);
void reference_free(reference *r);

/* The point of a camera's image at a depth; out: position and distance along the view axis. */
void reference_unproject(const view_data *view, const double at[2], double depth, float out[4]);

/* Where the corner of a box goes if its own position is not inside. */
void reference_middle(const view_data *view, const meder_box *box, uint32_t corner,
                      double position[3]);

/* Some triangles of light above and around the view's target. */
void reference_lights(light_data *lights, int count);

/* Largest difference of the lobes of a record from those gathered here at its position: of the
 * axes, of the flux relative to itself, of the mean length. */
double reference_lobe_difference(const light_data *lights, int count, const meder_record *record);

#endif
