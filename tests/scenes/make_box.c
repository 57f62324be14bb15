/* Writes the meshes of the built-in scene to standard output: room.obj, or with an argument
 * sphere.obj. The committed files are what this program writes. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double pi = 3.14159265358979323846;
static int vertices; /* written so far: OBJ counts from 1 */

static int vertex(double x, double y, double z)
{
    /* + 0.0: no negative zero */
    printf("v %.6g %.6g %.6g\n", rint(x * 1e6) / 1e6 + 0.0, rint(y * 1e6) / 1e6 + 0.0,
           rint(z * 1e6) / 1e6 + 0.0);
    return ++vertices;
}

static void object(const char *name, const char *material)
{
    printf("o %s\nusemtl %s\n", name, material);
}

/* Corners counter-clockwise, seen from the side that is looked at. */
static void quad(const double corners[4][3])
{
    int first = 0;
    for (int i = 0; i < 4; i++) {
        int index = vertex(corners[i][0], corners[i][1], corners[i][2]);
        first = i == 0 ? index : first;
    }
    printf("f %d %d %d %d\n", first, first + 1, first + 2, first + 3);
}

/* A box on centre, turned about the y axis by degrees. */
static void block(const double centre[3], const double half[3], double degrees)
{
    static const int sides[6][4] = {{1, 5, 7, 3}, {0, 2, 6, 4}, {2, 3, 7, 6},
                                    {0, 4, 5, 1}, {4, 6, 7, 5}, {0, 1, 3, 2}};
    double c = cos(degrees * pi / 180), s = sin(degrees * pi / 180);
    for (int side = 0; side < 6; side++) {
        double corners[4][3];
        for (int i = 0; i < 4; i++) {
            int k = sides[side][i];
            double x = k & 1 ? half[0] : -half[0], z = k & 4 ? half[2] : -half[2];
            corners[i][0] = centre[0] + c * x + s * z;
            corners[i][1] = centre[1] + (k & 2 ? half[1] : -half[1]);
            corners[i][2] = centre[2] - s * x + c * z;
        }
        quad(corners);
    }
}

/* An upright rod of twelve sides, closed above. */
static void rod(double x, double z, double radius, double height)
{
    enum { SIDES = 12 };
    int first = vertices + 1;
    for (int i = 0; i < SIDES; i++)
        for (int k = 0; k < 2; k++)
            vertex(x + radius * cos(2 * pi * i / SIDES), k * height,
                   z - radius * sin(2 * pi * i / SIDES));
    for (int i = 0; i < SIDES; i++) {
        int next = (i + 1) % SIDES;
        printf("f %d %d %d %d\n", first + 2 * i, first + 2 * next, first + 2 * next + 1,
               first + 2 * i + 1);
    }
    printf("f");
    for (int i = 0; i < SIDES; i++)
        printf(" %d", first + 2 * i + 1);
    printf("\n");
}

static void room(void)
{
    printf("# The built-in scene but for its sphere; written by make_box.c.\nmtllib room.mtl\n");
    object("floor", "white");
    quad((const double[4][3]){{-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1}});
    object("ceiling", "white");
    quad((const double[4][3]){{-1, 2, -1}, {1, 2, -1}, {1, 2, 1}, {-1, 2, 1}});
    object("back", "white");
    quad((const double[4][3]){{-1, 0, -1}, {1, 0, -1}, {1, 2, -1}, {-1, 2, -1}});
    object("left", "red");
    quad((const double[4][3]){{-1, 0, 1}, {-1, 0, -1}, {-1, 2, -1}, {-1, 2, 1}});
    object("right", "green");
    quad((const double[4][3]){{1, 0, -1}, {1, 0, 1}, {1, 2, 1}, {1, 2, -1}});
    object("tall_box", "blue");
    block((const double[3]){0.45, 0.6, -0.4}, (const double[3]){0.25, 0.6, 0.25}, 18);
    object("panel", "yellow");
    block((const double[3]){-0.35, 1.4, -0.3}, (const double[3]){0.35, 0.2, 0.002}, -30);
    /* seen along its length by the first camera */
    object("grazing_wall", "white");
    block((const double[3]){0.04, 0.2, -0.1}, (const double[3]){0.003, 0.2, 0.75}, 1.6);
    object("rod", "yellow");
    rod(0.75, 0.45, 0.012, 1.4);
}

/* ---- The sphere: an icosahedron, each side cut in four four times
 * --------------------------------- */

enum { CUTS = 4, MOST = 2562 };
static double points[MOST][3];
static int point_count;

static int point(double x, double y, double z)
{
    double length = sqrt(x * x + y * y + z * z);
    double p[3] = {x / length, y / length, z / length};
    for (int i = 0; i < point_count; i++)
        if (fabs(points[i][0] - p[0]) + fabs(points[i][1] - p[1]) + fabs(points[i][2] - p[2]) <
            1e-9)
            return i;
    for (int k = 0; k < 3; k++)
        points[point_count][k] = p[k];
    return point_count++;
}

static int between(int a, int b)
{
    return point(points[a][0] + points[b][0], points[a][1] + points[b][1],
                 points[a][2] + points[b][2]);
}

static void cut(int a, int b, int c, int times, int (*faces)[3], int *count)
{
    if (times == 0) {
        faces[*count][0] = a;
        faces[*count][1] = b;
        faces[(*count)++][2] = c;
        return;
    }
    int ab = between(a, b), bc = between(b, c), ca = between(c, a);
    cut(a, ab, ca, times - 1, faces, count);
    cut(ab, b, bc, times - 1, faces, count);
    cut(ca, bc, c, times - 1, faces, count);
    cut(ab, bc, ca, times - 1, faces, count);
}

static void sphere(void)
{
    static const int sides[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                     {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                     {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                     {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    static int faces[20 << (2 * CUTS)][3];
    double g = (1 + sqrt(5)) / 2;
    int count = 0;
    const double corners[12][3] = {{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                                   {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                                   {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
    for (int i = 0; i < 12; i++)
        point(corners[i][0], corners[i][1], corners[i][2]);
    for (int i = 0; i < 20; i++)
        cut(sides[i][0], sides[i][1], sides[i][2], CUTS, faces, &count);
    printf("# A sphere of radius 1 in %d triangles; written by make_box.c.\no sphere\n", count);
    for (int i = 0; i < point_count; i++)
        vertex(points[i][0], points[i][1], points[i][2]);
    for (int i = 0; i < count; i++)
        printf("f %d %d %d\n", faces[i][0] + 1, faces[i][1] + 1, faces[i][2] + 1);
}

int main(int argc, char **argv)
{
    (void)argv;
    if (argc > 1)
        sphere();
    else
        room();
    return fflush(stdout) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
