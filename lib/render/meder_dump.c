/* A picture of every stage of the pipeline `meder`. */
#include "meder.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/file.h"
#include "canvas.h"

/* Everything that the pictures are made of, on the host. */
typedef struct stages {
    uint32_t quads;
    const meder_box *boxes;  /* in the list's order by index */
    const uint32_t *indices; /* of boxes, one a quad */
    meder_record *records;   /* 4 a quad */
    float *lobes;            /* 4 a pixel */
    float *downsampled;      /* MEDER_SIDE^2 */
    uint32_t *labels;
    float *depth, *light; /* of the frame: 1 and 4 a pixel */
} stages;

static gpu_status read_image(gpu_image *image, void **texels)
{
    *texels =
        malloc((size_t)gpu_image_width(image) * gpu_image_height(image) * gpu_image_texel(image));
    if (!*texels)
        return gpu_fail(GPU_OUT_OF_MEMORY, "meder: out of host memory");
    return gpu_image_read(image, *texels);
}

static gpu_status read_stages(render_frame *frame, meder *m, stages *s)
{
    s->quads = meder_quad_count(m);
    s->boxes = gpu_buffer_map(m->boxes);
    s->indices = gpu_buffer_map(m->quads);
    gpu_status status = meder_record_corners(frame, m, &s->records, &s->lobes);
    if (status == GPU_OK)
        status = read_image(m->downsampled, (void **)&s->downsampled);
    if (status == GPU_OK)
        status = read_image(m->labels, (void **)&s->labels);
    if (status == GPU_OK)
        status = read_image(frame->depth, (void **)&s->depth);
    if (status == GPU_OK)
        status = read_image(frame->light, (void **)&s->light);
    return status;
}

static void free_stages(stages *s)
{
    free(s->records);
    free(s->lobes);
    free(s->downsampled);
    free(s->labels);
    free(s->depth);
    free(s->light);
}

/* ---- Pictures of the downsampled depth ----------------------------------------------------------
 */

static bool draw_segments(const stages *s, const char *folder)
{
    canvas c = canvas_open(MEDER_SIDE, MEDER_SIDE);
    canvas_depth(&c, s->downsampled, MEDER_SIDE * MEDER_SIDE);
    bool done = canvas_write(&c, folder, "downsampling.png");
    for (int y = 0; y < MEDER_SIDE; y++)
        for (int x = 0; x < MEDER_SIDE; x++) {
            size_t i = (size_t)y * MEDER_SIDE + (size_t)x;
            uint32_t tile = (uint32_t)(y / MEDER_TILE * MEDER_TILES + x / MEDER_TILE);
            if (s->downsampled[i] < 1)
                canvas_set(&c, x, y, canvas_number(tile * 1024 + s->labels[i]));
        }
    done = done && canvas_write(&c, folder, "segments.png");
    canvas_depth(&c, s->downsampled, MEDER_SIDE * MEDER_SIDE);
    for (uint32_t i = 0; i < s->quads; i++) {
        const meder_box *box = &s->boxes[s->indices[i]];
        canvas_outline(&c, (int)box->low[0], (int)box->low[1], (int)box->high[0], (int)box->high[1],
                       canvas_number(box->segment));
    }
    done = done && canvas_write(&c, folder, "boxes.png");
    canvas_close(&c);
    return done;
}

/* ---- Pictures of the quads
 * ------------------------------------------------------------------------ */

static const canvas_color edge = {235, 235, 235}, kept = {60, 220, 60}, moved = {255, 60, 60};

/* Edges, and a dot at each corner: green where its position comes from the G-buffer, red where it
 * was corrected. */
static bool draw_wireframe(const render_frame *frame, const stages *s, const char *folder)
{
    int width = (int)frame->width, height = (int)frame->height;
    canvas c = canvas_open(width, height);
    canvas_depth(&c, s->depth, (size_t)width * (size_t)height);
    for (int pass = 0; pass < 2; pass++)
        for (uint32_t i = 0; i < s->quads; i++) {
            const meder_box *box = &s->boxes[s->indices[i]];
            int x[2] = {(int)(box->low[0] * frame->width / MEDER_SIDE),
                        (int)((box->high[0] + 1) * frame->width / MEDER_SIDE) - 1};
            int y[2] = {(int)(box->low[1] * frame->height / MEDER_SIDE),
                        (int)((box->high[1] + 1) * frame->height / MEDER_SIDE) - 1};
            if (pass == 0) {
                canvas_outline(&c, x[0], y[0], x[1], y[1], edge);
                canvas_line(&c, x[1], y[0], x[0], y[1], edge);
            }
            for (int k = 0; k < 4 && pass == 1; k++)
                canvas_outline(&c, x[k & 1], y[k >> 1], x[k & 1] + 1, y[k >> 1] + 1,
                               s->records[4 * i + (uint32_t)k].corrected > 0 ? moved : kept);
        }
    bool done = canvas_write(&c, folder, "quads.png");
    canvas_close(&c);
    return done;
}

/* Coordinates seen from above the camera: to the right of the eye, and ahead of it. */
static void plan(const float *view, const float *position, double out[2])
{
    /* struct View: two matrices, then eye, right, up, forward */
    const float *eye = view + 32, *right = view + 36, *forward = view + 44;
    out[0] = out[1] = 0;
    for (int k = 0; k < 3; k++) {
        out[0] += ((double)position[k] - (double)eye[k]) * (double)right[k];
        out[1] += ((double)position[k] - (double)eye[k]) * (double)forward[k];
    }
}

/* The quads seen from above, with corners where the G-buffer has them, or after the correction; to
 * the same scale. */
static bool draw_plan(render_frame *frame, const stages *s, bool after, const char *folder)
{
    enum { SIZE = 1024 };
    const float *view = gpu_buffer_map(frame->view);
    double reach = 1e-3;
    for (uint32_t i = 0; i < 4 * s->quads; i++) {
        double at[2];
        plan(view, s->records[i].after, at);
        reach = fmax(reach, fmax(at[1], 2 * fabs(at[0])));
    }
    canvas c = canvas_open(SIZE, SIZE);
    for (uint32_t i = 0; i < s->quads; i++) {
        static const int order[5] = {0, 1, 3, 2, 0};
        int x[4], y[4];
        bool whole = true;
        for (uint32_t k = 0; k < 4; k++) {
            const meder_record *r = &s->records[4 * i + k];
            double at[2];
            plan(view, after ? r->after : r->before, at);
            whole = whole && (after || r->surface > 0);
            double px = SIZE * (0.5 + 0.5 * 2 * at[0] / reach), py = SIZE * (1 - at[1] / reach);
            x[k] = (int)fmin(fmax(px, -SIZE), 2 * SIZE);
            y[k] = (int)fmin(fmax(py, -SIZE), 2 * SIZE);
        }
        for (int k = 0; k < 4 && whole; k++)
            canvas_line(&c, x[order[k]], y[order[k]], x[order[k + 1]], y[order[k + 1]],
                        (canvas_color){90, 90, 90});
        for (uint32_t k = 0; k < 4; k++)
            if (after || s->records[4 * i + k].surface > 0)
                canvas_outline(&c, x[k], y[k], x[k] + 1, y[k] + 1,
                               s->records[4 * i + k].corrected > 0 ? moved : kept);
    }
    bool done = canvas_write(&c, folder, after ? "vertices_after.png" : "vertices_before.png");
    canvas_close(&c);
    return done;
}

/* ---- Pictures of the pixels
 * ----------------------------------------------------------------------- */

static uint8_t half_sphere(float component)
{
    return (uint8_t)lround(127.5 * (1 + fmin(fmax((double)component, -1), 1)));
}

static canvas_color owner_color(const float *light, float depth)
{
    if (depth >= 1)
        return (canvas_color){0, 0, 0};
    if (light[3] == 1)
        return (canvas_color){120, 120, 120};
    return light[3] == -2 ? (canvas_color){255, 200, 0} : (canvas_color){255, 0, 0};
}

/* The interpolated lobe of the green channel: sharpness from 0.1 to 100 by its logarithm, axis as a
 * colour; and which pixels are lit (grey), wrongly owned (yellow) or uncovered (red). */
static bool draw_pixels(const render_frame *frame, const stages *s, const char *folder)
{
    int width = (int)frame->width, height = (int)frame->height;
    canvas sharpness = canvas_open(width, height), axis = canvas_open(width, height),
           owners = canvas_open(width, height);
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            size_t i = (size_t)y * (size_t)width + (size_t)x;
            const float *lobe = s->lobes + 4 * i;
            canvas_set(&owners, x, y, owner_color(s->light + 4 * i, s->depth[i]));
            if (lobe[0] == 0 && lobe[1] == 0 && lobe[2] == 0)
                continue;
            canvas_set(&sharpness, x, y, canvas_scale((log10((double)lobe[3]) + 1) / 3));
            canvas_set(
                &axis, x, y,
                (canvas_color){half_sphere(lobe[0]), half_sphere(lobe[1]), half_sphere(lobe[2])});
        }
    bool done = canvas_write(&sharpness, folder, "sharpness.png") &&
                canvas_write(&axis, folder, "axis.png") &&
                canvas_write(&owners, folder, "ownership.png");
    canvas_close(&sharpness);
    canvas_close(&axis);
    canvas_close(&owners);
    return done;
}

bool meder_dump(render_frame *frame, void *state, const char *folder)
{
    stages s = {0};
    bool done = base_make_directory(folder);
    if (done && read_stages(frame, state, &s) != GPU_OK) {
        fprintf(stderr, "sgfit: %s\n", gpu_last_error());
        done = false;
    }
    done = done && draw_segments(&s, folder) && draw_wireframe(frame, &s, folder) &&
           draw_plan(frame, &s, false, folder) && draw_plan(frame, &s, true, folder) &&
           draw_pixels(frame, &s, folder);
    free_stages(&s);
    return done;
}
