/* A camera as the shaders want it. */
#include "internal.h"

#include <math.h>
#include <string.h>

/* Gauss-Jordan with pivots; the camera's matrix is far from singular. */
static void invert(double matrix[4][4], double inverse[4][4])
{
    double work[4][8];
    for (int row = 0; row < 4; row++)
        for (int column = 0; column < 4; column++) {
            work[row][column] = matrix[row][column];
            work[row][4 + column] = row == column;
        }
    for (int step = 0; step < 4; step++) {
        int pivot = step;
        for (int row = step + 1; row < 4; row++)
            if (fabs(work[row][step]) > fabs(work[pivot][step]))
                pivot = row;
        for (int column = 0; column < 8; column++) {
            double other = work[step][column];
            work[step][column] = work[pivot][column];
            work[pivot][column] = other;
        }
        double scale = 1 / work[step][step];
        for (int column = 0; column < 8; column++)
            work[step][column] *= scale;
        for (int row = 0; row < 4; row++) {
            double factor = work[row][step];
            for (int column = 0; row != step && column < 8; column++)
                work[row][column] -= factor * work[step][column];
        }
    }
    for (int row = 0; row < 4; row++)
        for (int column = 0; column < 4; column++)
            inverse[row][column] = work[row][4 + column];
}

static void store(double matrix[4][4], float columns[16])
{
    for (int row = 0; row < 4; row++)
        for (int column = 0; column < 4; column++)
            columns[4 * column + row] = (float)matrix[row][column];
}

static void store_axis(const double row[4], double sign, float axis[4])
{
    double length = sqrt(row[0] * row[0] + row[1] * row[1] + row[2] * row[2]);
    for (int i = 0; i < 3; i++)
        axis[i] = (float)(sign * row[i] / length);
}

void view_fill(const render_camera *camera, uint32_t width, uint32_t height, view_data *view)
{
    const double degree = 3.14159265358979323846 / 180;
    double aspect = (double)width / height;
    double clip_from_world[4][4], world_from_clip[4][4];
    render_camera_matrix(camera, aspect, clip_from_world);
    invert(clip_from_world, world_from_clip);
    memset(view, 0, sizeof *view);
    store(clip_from_world, view->clip_from_world);
    store(world_from_clip, view->world_from_clip);
    for (int i = 0; i < 3; i++)
        view->eye[i] = (float)camera->eye[i];
    double slope = tan(0.5 * degree * camera->fov_y_deg);
    view->eye[3] = (float)(2 * slope / height);
    /* the rows of the matrix are the camera's axes, scaled; y points down in clip space */
    store_axis(clip_from_world[0], 1, view->right);
    store_axis(clip_from_world[1], -1, view->up);
    store_axis(clip_from_world[3], 1, view->forward);
    view->range[0] = (float)camera->near;
    view->range[1] = (float)camera->far;
    view->range[2] = (float)aspect;
    view->range[3] = (float)slope;
    view->size[0] = width;
    view->size[1] = height;
}
