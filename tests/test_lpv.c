/* The passes of the light propagation volume against the same done on the host, and where light
 * may go. */
#include "lpv_fixture.h"

static void near_to(double found, double expected, double tolerance, const char *what)
{
    if (!(fabs(found - expected) <= tolerance))
        fail_msg("%s: %.9g, expected %.9g within %.2g", what, found, expected, tolerance);
}

/* Deposits flux (W) of all colours in a voxel, as a surface of 1 m^2 with that normal does. */
static void put(grid *g, uint32_t voxel, float flux, const float normal[3])
{
    lpv_sample *sample = gpu_buffer_map(g->samples);
    float *reflected = gpu_buffer_map(g->reflected);
    uint32_t *first = gpu_buffer_map(g->first);
    *sample = (lpv_sample){.normal = {normal[0], normal[1], normal[2]}};
    for (int k = 0; k < 3; k++)
        reflected[k] = flux;
    for (uint32_t v = 0; v <= g->push.voxels; v++)
        first[v] = v > voxel;
    *(struct lpv_entry *)gpu_buffer_map(g->entries) = (struct lpv_entry){0, 1};
    grid_deposit(g);
}

/* ---- Deposit -------------------------------------------------------------------------- */

static void deposits_are_lobes_of_their_flux(void **state)
{
    (void)state;
    grid g;
    grid_open(&g, 3, 2, 2, 0.5F);
    lpv_sample *samples = gpu_buffer_map(g.samples);
    float *reflected = gpu_buffer_map(g.reflected);
    uint32_t *first = gpu_buffer_map(g.first);
    struct lpv_entry *entries = gpu_buffer_map(g.entries);
    samples[0] = (lpv_sample){.normal = {0, 0.6F, 0.8F}};
    samples[1] = (lpv_sample){.normal = {1, 0, 0}};
    for (int i = 0; i < 4 * 4; i++)
        reflected[i] = (float)(1 + i % 4 + i / 4);
    /* voxel 4: both sides of a sample and one of another, voxel 7: one side */
    const struct lpv_entry list[] = {{0, 0.5F}, {1, 0.25F}, {2, 2}, {3, 0.125F}};
    memcpy(entries, list, sizeof list);
    for (uint32_t v = 0; v <= 12; v++)
        first[v] = v <= 4 ? 0 : v <= 7 ? 3 : 4;
    grid_deposit(&g);
    for (uint32_t v = 0; v < 12; v++)
        for (int c = 0; c < 3; c++) {
            double flux = 0, along[3] = {0, 0, 0};
            float expected[4];
            for (uint32_t e = first[v]; e < first[v + 1]; e++) {
                const lpv_sample *s = &samples[list[e].side / 2];
                double part =
                    (double)list[e].area * (double)reflected[4 * list[e].side + (uint32_t)c];
                flux += part;
                for (int k = 0; k < 3; k++)
                    along[k] += (list[e].side % 2 ? -part : part) * 2 / 3 * (double)s->normal[k];
            }
            host_lobe(&g, along, flux, expected);
            for (int k = 0; k < 4; k++)
                near_to((double)grid_lobes(&g)[v].of[c][k], (double)expected[k],
                        1e-5 * (1 + fabs((double)expected[k])), "lobe");
            near_to(host_sum(grid_lobes(&g)[v].of[c]), flux, 1e-5 * flux, "flux");
        }
    grid_close(&g);
}

/* ---- A step --------------------------------------------------------------------------- */

/* Flux and flux times direction that voxel (x, y, z) gets, and what passes it. */
static void host_step(const grid *g, const lobes_data *lobes, const uint32_t at[3], int colour,
                      double along[3], double *flux, double passed[6])
{
    const float *open = gpu_buffer_map(g->open);
    memset(along, 0, 3 * sizeof *along);
    memset(passed, 0, 6 * sizeof *passed);
    *flux = 0;
    for (int way = 0; way < 6; way++) {
        uint32_t from[3] = {at[0], at[1], at[2]};
        int axis = way / 2;
        from[axis] += way % 2 ? 1 : UINT32_MAX;
        if (from[axis] >= g->push.size[axis])
            continue;
        uint32_t source = grid_voxel(g, from[0], from[1], from[2]);
        uint32_t lower = way % 2 ? grid_voxel(g, at[0], at[1], at[2]) : source;
        for (int i = 0; i < 30; i++) {
            host_part p = host_part_of(i);
            double f = host_flux(lobes[source].of[colour], &p) * host_share(&p, way) *
                       (double)open[4 * lower + (uint32_t)axis];
            *flux += f;
            for (int k = 0; k < 3; k++)
                along[k] += f * p.mean[k];
            /* straight light that goes astray counts as straight */
            for (int to = 0; to < 6; to++)
                passed[to] += f * (p.beside < 0 && way != p.to ? to == p.to : host_share(&p, to));
        }
    }
}

static void a_step_is_the_hosts(void **state)
{
    (void)state;
    grid g;
    grid_open(&g, 4, 3, 2, 0.5F);
    float *open = gpu_buffer_map(g.open);
    for (uint32_t i = 0; i < 96; i++)
        open[i] = i % 7 == 0 ? 0 : 1 - (float)(i % 5) / 6;
    put(&g, 6, 2, (float[]){0.48F, 0.6F, -0.64F});
    lobes_data before[24];
    for (int step = 0; step < 4; step++) {
        passed_data sums[24];
        memcpy(before, grid_lobes(&g), sizeof before);
        memcpy(sums, grid_sums(&g), sizeof sums);
        grid_propagate(&g, 1);
        for (uint32_t v = 0; v < 24; v++) {
            const uint32_t at[3] = {v % 4, v / 4 % 3, v / 12};
            for (int c = 0; c < 3; c++) {
                double along[3], flux, passed[6];
                float expected[4];
                host_step(&g, before, at, c, along, &flux, passed);
                host_lobe(&g, along, flux, expected);
                for (int k = 0; k < 4; k++)
                    near_to((double)grid_lobes(&g)[v].of[c][k], (double)expected[k], 2e-5, "lobe");
                for (int k = 0; k < 6; k++)
                    near_to((double)grid_sums(&g)[v].by[k][c], (double)sums[v].by[k][c] + passed[k],
                            1e-5, "passed");
            }
        }
    }
    grid_close(&g);
}

/* ---- Energy --------------------------------------------------------------------------- */

/* What a wall keeps or the boundary lets out in the next step, W. */
static double host_lost(const grid *g, bool boundary)
{
    const float *open = gpu_buffer_map(g->open);
    double sum = 0;
    for (uint32_t v = 0; v < g->push.voxels; v++) {
        const uint32_t *n = g->push.size, at[3] = {v % n[0], v / n[0] % n[1], v / (n[0] * n[1])};
        for (int way = 0; way < 6; way++) {
            uint32_t to[3] = {at[0], at[1], at[2]};
            to[way / 2] += way % 2 ? UINT32_MAX : 1;
            bool out = to[way / 2] >= n[way / 2];
            uint32_t lower = way % 2 && !out ? grid_voxel(g, to[0], to[1], to[2]) : v;
            double kept = out ? 1 : 1 - (double)open[4 * lower + (uint32_t)way / 2];
            for (int i = 0; i < 30 && out == boundary; i++) {
                host_part p = host_part_of(i);
                sum += kept * host_flux(grid_lobes(g)[v].of[0], &p) * host_share(&p, way);
            }
        }
    }
    return sum;
}

/* A box of white walls inside the volume: they keep what reaches them, nothing gets out. */
static void light_in_a_closed_box_ends_in_its_walls(void **state)
{
    (void)state;
    grid g;
    grid_open(&g, 9, 9, 9, 1);
    float *open = gpu_buffer_map(g.open);
    for (uint32_t i = 0; i < 81; i++)
        for (int side = 0; side < 2; side++) {
            uint32_t plane = side ? 7 : 1, a = i % 9, b = i / 9;
            open[4 * grid_voxel(&g, plane - !side, a, b)] = 0;
            open[4 * grid_voxel(&g, a, plane - !side, b) + 1] = 0;
            open[4 * grid_voxel(&g, a, b, plane - !side) + 2] = 0;
        }
    put(&g, grid_voxel(&g, 2, 4, 5), 3, (float[]){0.6F, 0.8F, 0});
    double energy = host_energy(&g, 0), kept = 0;
    near_to(energy, 3, 3e-5, "deposited");
    for (int step = 0; step < 60; step++) {
        double walls = host_lost(&g, false);
        near_to(host_lost(&g, true), 0, 0, "lost through the boundary");
        grid_propagate(&g, 1);
        double now = host_energy(&g, 0);
        assert_true(now <= energy * (1 + 1e-6));
        near_to(now, energy - walls, 1e-5, "what the walls left");
        kept += walls;
        energy = now;
    }
    near_to(energy + kept, 3, 1e-4, "light and what was kept");
    assert_true(energy < 0.03);
    grid_close(&g);
}

/* Without walls all leaves through the boundary, and less than all before the light has got there.
 */
static void light_in_the_open_leaves(void **state)
{
    (void)state;
    grid g;
    grid_open(&g, 9, 9, 9, 1);
    put(&g, grid_voxel(&g, 4, 4, 4), 1, (float[]){0, 1, 0});
    grid_propagate(&g, 4);
    near_to(host_energy(&g, 0), 1, 1e-5, "before the boundary");
    double left = 0;
    for (int step = 0; step < 60; step++) {
        left += host_lost(&g, true);
        grid_propagate(&g, 1);
        near_to(host_energy(&g, 0) + left, 1, 1e-4, "light and what left");
    }
    assert_true(left > 0.98);
    grid_close(&g);
}

/* A source that shines in all directions alike: a sixth of it passes through each face of any cube
 * around it, so that irradiance falls with the square of the distance; along the axes, where most
 * of the light goes from voxel to voxel, there is more than that close by. */
static void a_point_source_falls_off(void **state)
{
    enum { N = 21, C = N / 2 };
    (void)state;
    grid g;
    grid_open(&g, N, N, N, 1);
    put(&g, grid_voxel(&g, C, C, C), 1, (float[]){0, 0, 0});
    grid_propagate(&g, 80);
    double before[2] = {0, 0};
    for (uint32_t r = 2; r <= 8; r *= 2) {
        double face = 0, back = 0;
        for (uint32_t y = C - r; y <= C + r; y++)
            for (uint32_t z = C - r; z <= C + r; z++) {
                const passed_data *p = &grid_sums(&g)[grid_voxel(&g, C + r, y, z)];
                double edge =
                    (y == C - r || y == C + r ? 0.5 : 1) * (z == C - r || z == C + r ? 0.5 : 1);
                face += edge * (double)p->by[0][0];
                back += edge * (double)p->by[1][0];
            }
        double axis = (double)grid_sums(&g)[grid_voxel(&g, C + r, C, C)].by[0][0];
        double mean = face / (4 * r * r), truth = 1 / (4 * 3.14159265358979323846 * r * r);
        printf("%u voxels away: %.3f of a sixth through the cube's face, %.3f back through it; on "
               "the axis %.2f of 1/(4 pi r^2)\n",
               r, 6 * face, 6 * back, axis / truth);
        near_to(6 * face, 1, 0.3, "through a face");
        near_to(6 * (face - back), 1, 0.2, "through a face, less what comes back");
        if (r > 2) {
            near_to(before[0] / mean, 4, 0.6, "mean irradiance at half the distance");
            assert_true(axis < before[1]);
        }
        before[0] = mean, before[1] = axis;
    }
    grid_close(&g);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(deposits_are_lobes_of_their_flux),
        cmocka_unit_test(a_step_is_the_hosts),
        cmocka_unit_test(light_in_a_closed_box_ends_in_its_walls),
        cmocka_unit_test(light_in_the_open_leaves),
        cmocka_unit_test(a_point_source_falls_off),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
