/* Rays against triangles on the device, ray by ray against Embree's own tracer. Where the two
 * differ the ray must pass within a millionth of the scene's size of some triangle's edge, or
 * within a few roundings of its plane. */
#include "pass_fixture.h"

#include <math.h>
#include <time.h>

#include "embree.h"
#include "render/render.h"
#include "render/trace.h"

enum { RAYS = 100000 };

typedef struct ray_data {
    float origin[3], far, direction[3], zero;
} ray_data;

typedef struct hit_data {
    uint32_t triangle;
    float at;
} hit_data;

static uint64_t seed = 1;

static float uniform(void) /* 0 to 1 */
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (float)(seed >> 40) * 0x1p-24f;
}

static void direction(float d[3])
{
    float z = 2 * uniform() - 1, angle = 6.2831853f * uniform(), r = sqrtf(1 - z * z);
    d[0] = r * cosf(angle);
    d[1] = r * sinf(angle);
    d[2] = z;
}

/* ---- On the device ------------------------------------------------------------------- */

typedef struct fixture {
    gpu_device *device;
    gpu_compute *compute;
} fixture;

static fixture open_fixture(void)
{
    static const gpu_binding bindings[] = {GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER,
                                           GPU_STORAGE_BUFFER, GPU_STORAGE_BUFFER};
    fixture f = {.device = open_software_device()};
    render_frame frame = {.device = f.device};
    must(render_compute(&frame, "trace/rays.comp", false, bindings, 4, 12, &f.compute));
    return f;
}

static void close_fixture(fixture *f)
{
    gpu_compute_destroy(f->compute);
    close_clean(f->device);
}

static double trace(fixture *f, const render_tracer *tracer, const ray_data *rays, uint32_t count,
                    bool any, hit_data *hits)
{
    gpu_buffer *in = make_buffer(f->device, count * sizeof *rays),
               *out = make_buffer(f->device, count * sizeof *hits);
    memcpy(gpu_buffer_map(in), rays, count * sizeof *rays);
    uint32_t push[3] = {tracer->root, count, any};
    double seconds;
    gpu_step step = {.name = "rays",
                     .compute = f->compute,
                     .resources = {tracer->nodes, tracer->triangles, in, out},
                     .push = push,
                     .groups = {(count + 63) / 64, 1, 1}};
    must(gpu_run(f->device, &step, 1, &seconds));
    memcpy(hits, gpu_buffer_map(out), count * sizeof *hits);
    gpu_buffer_destroy(in);
    gpu_buffer_destroy(out);
    return seconds;
}

/* ---- Scenes -------------------------------------------------------------------------- */

static render_scene soup(size_t triangles, float size)
{
    render_scene scene = {.vertex_count = 3 * triangles, .triangle_count = triangles};
    scene.positions = malloc(9 * triangles * sizeof(float) + 1);
    scene.indices = malloc(3 * triangles * sizeof(uint32_t) + 1);
    for (size_t t = 0; t < triangles; t++) {
        float centre[3] = {uniform(), uniform(), uniform()};
        float *p = scene.positions + 9 * t;
        for (int i = 0; i < 9; i++)
            p[i] = centre[i % 3] + size * (uniform() - 0.5f);
        if (t % 16 == 1) /* a line, a point, one seen twice, one in an axis' plane */
            memcpy(p + 6, p + 3, 12);
        if (t % 64 == 2)
            memcpy(p + 3, p, 12), memcpy(p + 6, p, 12);
        if (t % 32 == 3)
            memcpy(p, p - 9, 36);
        if (t % 8 == 4)
            p[1] = p[4] = p[7] = centre[1];
        for (uint32_t i = 0; i < 3; i++)
            scene.indices[3 * t + i] = (uint32_t)(3 * t) + i;
    }
    return scene;
}

static render_scene read_scene(const char *name)
{
    char path[1000];
    const char *root = getenv("SGFIT_ROOT");
    snprintf(path, sizeof path, "%s/tests/scenes/%s.json", root ? root : ".", name);
    render_scene scene;
    assert_true(render_scene_read(path, NULL, &scene));
    return scene;
}

static void corner(const render_scene *scene, size_t triangle, int i, float p[3])
{
    memcpy(p, scene->positions + 3 * scene->indices[3 * triangle + (size_t)i % 3], 12);
}

static double size_of(const render_scene *scene)
{
    double most = 0;
    for (size_t i = 0; i < 3 * scene->vertex_count; i++)
        most = fmax(most, fabs((double)scene->positions[i]));
    return most;
}

/* ---- Rays ---------------------------------------------------------------------------- */

static void weigh(const render_scene *scene, size_t t, const float weights[3], float p[3])
{
    float c[3];
    memset(p, 0, 12);
    for (int i = 0; i < 3; i++) {
        corner(scene, t, i, c);
        for (int k = 0; k < 3; k++)
            p[k] += weights[i] * c[k];
    }
}

static void inside(const render_scene *scene, size_t t, float p[3])
{
    float a = uniform(), b = uniform() * (1 - a);
    weigh(scene, t, (float[3]){a, b, 1 - a - b}, p);
}

static void towards(ray_data *ray, const float target[3])
{
    for (int k = 0; k < 3; k++)
        ray->direction[k] = target[k] - ray->origin[k];
}

static void adversary(const render_scene *scene, int kind, float size, ray_data *ray)
{
    size_t t = (size_t)((float)scene->triangle_count * uniform() * 0.999999f),
           other = (size_t)((float)scene->triangle_count * uniform() * 0.999999f);
    float a = uniform(), target[3], b[3], c[3];
    switch (kind) {
    case 1: /* through a point of an edge */
        weigh(scene, t, (float[3]){a, 1 - a, 0}, target);
        towards(ray, target);
        break;
    case 2: /* through a corner */
        corner(scene, t, 1, target);
        towards(ray, target);
        break;
    case 3: /* along an edge, from before it */
        corner(scene, t, 0, b);
        corner(scene, t, 1, c);
        for (int k = 0; k < 3; k++)
            ray->origin[k] = b[k] - a * (c[k] - b[k]), ray->direction[k] = c[k] - b[k];
        break;
    case 4: /* in a triangle's plane */
        inside(scene, t, ray->origin);
        inside(scene, t, target);
        towards(ray, target);
        break;
    case 5: /* from a surface anywhere */
        inside(scene, t, ray->origin);
        direction(ray->direction);
        break;
    case 6: /* from surface to surface, not beyond */
        inside(scene, t, ray->origin);
        inside(scene, other, target);
        towards(ray, target);
        ray->far = 0.999f;
        break;
    case 7: /* along an axis, from a corner's coordinates */
        corner(scene, t, 0, ray->origin);
        memset(ray->direction, 0, sizeof ray->direction);
        ray->direction[other % 3] = other % 2 ? 1 : -1;
        ray->origin[other % 3] -= ray->direction[other % 3] * 3 * size;
        break;
    default:
        break;
    }
    if (ray->direction[0] == 0 && ray->direction[1] == 0 && ray->direction[2] == 0)
        ray->direction[kind % 3] = 1;
}

static ray_data *make_rays(const render_scene *scene)
{
    ray_data *rays = calloc(RAYS, sizeof *rays);
    float size = (float)size_of(scene);
    for (int i = 0; i < RAYS; i++) {
        for (int k = 0; k < 3; k++)
            rays[i].origin[k] = size * 1.2f * (2 * uniform() - 1);
        direction(rays[i].direction);
        rays[i].far = i % 3 ? 1e30f : size * uniform();
        if (i % 2)
            adversary(scene, i / 2 % 8, size, &rays[i]);
    }
    return rays;
}

/* ---- Telling where the two may differ -------------------------------------------------- */

static double length_of(const double v[3])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static void cross_of(const double a[3], const double b[3], double c[3])
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

static double dot_of(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Distance between the ray's line and the line piece from p to q, from below: of a piece that
 * runs along the ray, that of its ends. */
static double edge_distance(const ray_data *ray, const float p[3], const float q[3])
{
    double d[3], e[3], w[3], least = INFINITY;
    for (int k = 0; k < 3; k++) {
        d[k] = (double)ray->direction[k];
        e[k] = (double)q[k] - (double)p[k];
        w[k] = (double)p[k] - (double)ray->origin[k];
    }
    double dd = dot_of(d, d), ee = dot_of(e, e), de = dot_of(d, e), across = dd * ee - de * de;
    double along[3] = {0, 1, 0};
    if (across > 0)
        along[2] = fmin(fmax((de * dot_of(d, w) - dd * dot_of(e, w)) / across, 0), 1);
    for (int i = 0; i < 3; i++) {
        double from[3], side[3];
        for (int k = 0; k < 3; k++)
            from[k] = w[k] + along[i] * e[k];
        cross_of(from, d, side);
        least = fmin(least, length_of(side) / sqrt(dd));
    }
    return least;
}

/* The ray meets the triangle within a tolerance of its start or end, or runs along its plane. */
static bool at_an_end(const render_scene *scene, size_t t, const ray_data *ray, double tolerance)
{
    float c[3][3];
    double e[2][3], n[3], d[3], w[3];
    for (int i = 0; i < 3; i++)
        corner(scene, t, i, c[i]);
    for (int k = 0; k < 3; k++) {
        e[0][k] = (double)c[1][k] - (double)c[0][k];
        e[1][k] = (double)c[2][k] - (double)c[0][k];
        d[k] = (double)ray->direction[k];
        w[k] = (double)c[0][k] - (double)ray->origin[k];
    }
    cross_of(e[0], e[1], n);
    double size = length_of(n), step = length_of(d);
    if (!(size > 0))
        return false; /* a line: then an edge is near where anything is */
    double slope = dot_of(n, d) / size, height = dot_of(n, w) / size;
    if (fabs(slope) < 1e-5 * step && fabs(height) < tolerance)
        return true;
    return fabs(height) < tolerance ||
           (ray->far < 1e29f && fabs(height - slope * (double)ray->far) < tolerance);
}

static bool excused(const render_scene *scene, const ray_data *ray, double tolerance)
{
    for (size_t t = 0; t < scene->triangle_count; t++) {
        for (int i = 0; i < 3; i++) {
            float p[3], q[3];
            corner(scene, t, i, p);
            corner(scene, t, i + 1, q);
            if (edge_distance(ray, p, q) < tolerance)
                return true;
        }
        if (at_an_end(scene, t, ray, tolerance))
            return true;
    }
    return false;
}

/* ---- Tests --------------------------------------------------------------------------- */

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Every other ray is an adversary: aimed at an edge or a corner, in a plane, or begun on a surface,
 * where a rounding decides. Of those a fifth may differ, of the others one in a thousand. */
static void compare(fixture *f, const render_scene *scene, const char *name)
{
    render_tracer tracer;
    must(render_tracer_create(f->device, scene, &tracer));
    ray_data *rays = make_rays(scene);
    hit_data *nearest = malloc(RAYS * sizeof *nearest), *any = malloc(RAYS * sizeof *any);
    double seconds = trace(f, &tracer, rays, RAYS, false, nearest);
    double seconds_any = trace(f, &tracer, rays, RAYS, true, any);
    embree_scene embree = embree_open(scene);
    double size = size_of(scene), begin, embree_seconds = 0;
    int differ[2] = {0, 0}, hits = 0;
    for (int i = 0; i < RAYS; i++) {
        float at;
        begin = now();
        uint32_t expected =
            embree_closest(&embree, rays[i].origin, rays[i].direction, rays[i].far, &at);
        embree_seconds += now() - begin;
        bool hit = nearest[i].triangle != UINT32_MAX;
        assert_int_equal(hit, any[i].triangle != UINT32_MAX);
        hits += hit;
        double step = sqrt((double)rays[i].direction[0] * (double)rays[i].direction[0] +
                           (double)rays[i].direction[1] * (double)rays[i].direction[1] +
                           (double)rays[i].direction[2] * (double)rays[i].direction[2]);
        bool same = hit == (expected != UINT32_MAX) &&
                    (!hit || nearest[i].triangle == expected ||
                     fabs((double)nearest[i].at - (double)at) * step < 1e-5 * size);
        if (same)
            continue;
        differ[i % 2]++;
        if (!excused(scene, &rays[i], 2e-6 * size))
            fail_msg("%s, ray %d: triangle %u at %g, Embree %u at %g, far from every edge", name, i,
                     nearest[i].triangle, (double)nearest[i].at, expected, (double)at);
    }
    printf(
        "%s: %d of %d rays hit; %d random ones and %d adversaries differ from Embree, each at an "
        "edge or an end; speed: nearest %.3f, any %.3f of one core of Embree\n",
        name, hits, RAYS, differ[0], differ[1], embree_seconds / seconds,
        embree_seconds / seconds_any);
    assert_true(hits > RAYS / 20);
    assert_true(differ[0] <= RAYS / 2 / 1000);
    assert_true(differ[1] <= RAYS / 2 / 5);
    embree_close(&embree);
    free(rays);
    free(nearest);
    free(any);
    render_tracer_destroy(&tracer);
}

static void rays_hit_what_embree_hits(void **state)
{
    (void)state;
    fixture f = open_fixture();
    render_scene box = read_scene("box");
    compare(&f, &box, "box");
    render_scene_free(&box);
    const struct {
        size_t triangles;
        float size;
    } soups[] = {{40, 0.8f}, {1000, 0.2f}, {1000, 0.01f}};
    for (size_t i = 0; i < sizeof soups / sizeof *soups; i++) {
        char name[64];
        snprintf(name, sizeof name, "%zu triangles of size %g", soups[i].triangles,
                 (double)soups[i].size);
        render_scene scene = soup(soups[i].triangles, soups[i].size);
        compare(&f, &scene, name);
        render_scene_free(&scene);
    }
    close_fixture(&f);
}

/* A closed surface: from inside, whatever the ray is aimed at, it cannot leave. */
static void a_closed_surface_has_no_gaps(void **state)
{
    (void)state;
    enum { ROUND = 24, HIGH = 13, COUNT = 20000 };
    fixture f = open_fixture();
    render_scene scene = {.vertex_count = ROUND * HIGH,
                          .positions = malloc(sizeof(float) * 3 * ROUND * HIGH),
                          .indices = malloc(sizeof(uint32_t) * 6 * ROUND * HIGH)};
    for (int j = 0; j < HIGH; j++)
        for (int i = 0; i < ROUND; i++) {
            double up = 3.14159265358979 * j / (HIGH - 1), round = 6.28318530717959 * i / ROUND;
            double r = j % (HIGH - 1) ? sin(up) : 0; /* the poles are many equal corners */
            float p[3] = {(float)(10 + r * cos(round)), (float)cos(up), (float)(r * sin(round))};
            memcpy(scene.positions + 3 * (j * ROUND + i), p, sizeof p);
            if (j + 1 == HIGH)
                continue;
            uint32_t a = (uint32_t)(j * ROUND + i), b = (uint32_t)(j * ROUND + (i + 1) % ROUND);
            uint32_t two[6] = {a, b, a + ROUND, b, b + ROUND, a + ROUND};
            memcpy(scene.indices + 3 * scene.triangle_count, two, sizeof two);
            scene.triangle_count += 2;
        }
    render_tracer tracer;
    must(render_tracer_create(f.device, &scene, &tracer));
    ray_data *rays = calloc(COUNT, sizeof *rays);
    hit_data *hits = malloc(COUNT * sizeof *hits);
    for (int i = 0; i < COUNT; i++) {
        for (int k = 0; k < 3; k++)
            rays[i].origin[k] = (k == 0 ? 10 : 0) + 0.8f * (uniform() - 0.5f);
        direction(rays[i].direction);
        rays[i].far = 1e30f;
        float a = uniform(), target[3];
        size_t t = (size_t)((float)scene.triangle_count * 0.999999f * a);
        a = uniform();
        weigh(&scene, t, i % 4 == 1 ? (float[3]){a, 1 - a, 0} : (float[3]){1, 0, 0}, target);
        if (i % 4 == 1 || i % 4 == 2) /* an edge, a corner */
            towards(&rays[i], target);
    }
    trace(&f, &tracer, rays, COUNT, true, hits);
    for (int i = 0; i < COUNT; i++)
        if (hits[i].triangle == UINT32_MAX)
            fail_msg("ray %d leaves a closed surface", i);
    free(rays);
    free(hits);
    render_tracer_destroy(&tracer);
    render_scene_free(&scene);
    close_fixture(&f);
}

static void no_triangle_and_one(void **state)
{
    (void)state;
    fixture f = open_fixture();
    ray_data rays[2] = {{.origin = {0.2f, 0.2f, 1}, .far = 1e30f, .direction = {0, 0, -2}},
                        {.origin = {0.8f, 0.8f, 1}, .far = 1e30f, .direction = {0, 0, -2}}};
    hit_data hits[2];
    render_tracer tracer;
    render_scene scene = {0};
    must(render_tracer_create(f.device, &scene, &tracer));
    trace(&f, &tracer, rays, 2, false, hits);
    assert_int_equal(hits[0].triangle, UINT32_MAX);
    render_tracer_destroy(&tracer);
    float positions[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    uint32_t indices[3] = {0, 1, 2};
    scene = (render_scene){
        .vertex_count = 3, .triangle_count = 1, .positions = positions, .indices = indices};
    must(render_tracer_create(f.device, &scene, &tracer));
    for (int any = 0; any < 2; any++) {
        trace(&f, &tracer, rays, 2, any, hits);
        assert_int_equal(hits[0].triangle, 0);
        assert_true(hits[0].at == 0.5f);
        assert_int_equal(hits[1].triangle, UINT32_MAX);
    }
    render_tracer_destroy(&tracer);
    close_fixture(&f);
}

/* Every triangle is in one leaf, every box holds what is below it, twice the same tree. */
static uint32_t check_node(const render_bvh *bvh, uint32_t node, const float *low,
                           const float *high, uint32_t depth)
{
    assert_true(depth <= RENDER_BVH_DEPTH);
    if (node & RENDER_BVH_LEAF) {
        uint32_t first = (node & ~RENDER_BVH_LEAF) >> 3, count = (node & 7) + 1;
        for (uint32_t t = first; t < first + count; t++)
            for (int i = 0; i < 9; i++) {
                float x = bvh->triangles[12 * t + (uint32_t)(i / 3 * 4 + i % 3)];
                assert_true(!low || (x >= low[i % 3] && x <= high[i % 3]));
            }
        return count;
    }
    assert_true(node < bvh->node_count);
    const float *p = bvh->nodes + 16 * node;
    uint32_t children[2];
    memcpy(&children[0], p + 3, 4);
    memcpy(&children[1], p + 7, 4);
    return check_node(bvh, children[0], p, p + 4, depth + 1) +
           check_node(bvh, children[1], p + 8, p + 12, depth + 1);
}

static void the_tree_holds_everything(void **state)
{
    (void)state;
    render_scene scene = soup(5000, 0.1f);
    for (size_t i = 0; i < 9 * 1000; i++)
        scene.positions[i] = scene.positions[i % 9]; /* a thousand times the same triangle */
    render_bvh bvh, again;
    must(render_bvh_build(&scene, &bvh));
    must(render_bvh_build(&scene, &again));
    assert_int_equal(bvh.triangle_count, 5000);
    assert_int_equal(check_node(&bvh, bvh.root, NULL, NULL, 0), 5000);
    unsigned char *seen = calloc(5000, 1);
    for (size_t t = 0; t < 5000; t++) {
        uint32_t number;
        memcpy(&number, bvh.triangles + 12 * t + 3, 4);
        assert_true(number < 5000 && !seen[number]);
        seen[number] = 1;
    }
    assert_int_equal(bvh.node_count, again.node_count);
    assert_memory_equal(bvh.nodes, again.nodes, 64 * bvh.node_count);
    assert_memory_equal(bvh.triangles, again.triangles, 48 * bvh.triangle_count);
    free(seen);
    render_bvh_free(&bvh);
    render_bvh_free(&again);
    render_scene_free(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_tree_holds_everything),
        cmocka_unit_test(no_triangle_and_one),
        cmocka_unit_test(a_closed_surface_has_no_gaps),
        cmocka_unit_test(rays_hit_what_embree_hits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
