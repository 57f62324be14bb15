/* Mesh files: what they become, and that a damaged one ends in a mesh or in one line, soon. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

#include <cmocka.h>

#include "base/buffer.h"
#include "capture.h"
#include "mesh_files.h"
#include "mutate.h"
#include "render/mesh.h"
#include "work.h"

static void write_bytes(const char *name, const void *bytes, size_t size)
{
    FILE *file = fopen(workspace_path(&work, name), "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    assert_int_equal(fclose(file), 0);
}

static mesh read_good(const char *name)
{
    mesh m;
    assert_true(mesh_read(workspace_path(&work, name), NULL, &m));
    return m;
}

static void refused(const char *name, const mesh_limits *limits, const char *word)
{
    const char *file = strcmp(name, "m.obj") == 0 ? "m.materials.tsv" : name;
    capture c;
    mesh m;
    capture_begin(&c);
    bool good = mesh_read(workspace_path(&work, name), limits, &m);
    const char *text = capture_end(&c);
    assert_false(good);
    assert_one_line(text, file, word);
    assert_null(m.positions);
    assert_int_equal(m.vertex_count, 0);
}

/* A tetrahedron in each format: four faces, normals made, edges hard because 60 degrees are less
 * than theirs. */
static void test_formats(void **state)
{
    (void)state;
    buffer ply = mesh_file_ply(false, true), binary = mesh_file_ply(true, true),
           glb = mesh_file_glb(1, 0, 0);
    write_bytes("t.ply", ply.text, ply.length);
    write_bytes("b.PLY", binary.text, binary.length);
    write_bytes("t.glb", glb.text, glb.length);
    workspace_write(&work, "t.obj", mesh_file_obj);
    static const char *const names[] = {"t.ply", "b.PLY", "t.glb", "t.obj"};
    for (size_t i = 0; i < 4; i++) {
        mesh m = read_good(names[i]);
        assert_int_equal(m.triangle_count, 4);
        assert_int_equal(m.left_out, 0);
        double volume = 0;
        for (size_t t = 0; t < 4; t++) {
            const float *p[3];
            for (size_t k = 0; k < 3; k++)
                p[k] = &m.positions[3 * m.indices[3 * t + k]];
            volume += (double)(p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) +
                               p[0][1] * (p[1][2] * p[2][0] - p[1][0] * p[2][2]) +
                               p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0])) /
                      6;
        }
        assert_true(fabs(volume - 1.0 / 6) < 1e-6);
        mesh_free(&m);
    }
    buffer_free(&ply);
    buffer_free(&binary);
    buffer_free(&glb);
}

/* Scale and translation of a node, a mirrored one too: the volume stays positive. */
static void test_nodes(void **state)
{
    (void)state;
    static const float scales[] = {2, -2};
    for (size_t i = 0; i < 2; i++) {
        buffer glb = mesh_file_glb(scales[i], 5, 0);
        write_bytes("node.glb", glb.text, glb.length);
        mesh m = read_good("node.glb");
        double volume = 0;
        float low = INFINITY, high = -INFINITY;
        for (size_t t = 0; t < m.triangle_count; t++) {
            const float *p[3];
            for (size_t k = 0; k < 3; k++) {
                p[k] = &m.positions[3 * m.indices[3 * t + k]];
                low = fminf(low, p[k][0]);
                high = fmaxf(high, p[k][0]);
            }
            volume += (double)((p[0][0] - 5) * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) +
                               p[0][1] * (p[1][2] * (p[2][0] - 5) - (p[1][0] - 5) * p[2][2]) +
                               p[0][2] * ((p[1][0] - 5) * p[2][1] - p[1][1] * (p[2][0] - 5))) /
                      6;
        }
        assert_true(fabs(volume - 8.0 / 6) < 1e-5);
        assert_true(fabsf(low - (scales[i] > 0 ? 5 : 3)) < 1e-6F);
        assert_true(fabsf(high - (scales[i] > 0 ? 7 : 5)) < 1e-6F);
        mesh_free(&m);
        buffer_free(&glb);
    }
}

static void test_albedos(void **state)
{
    (void)state;
    workspace_write(&work, "m.mtl",
                    "newmtl plain\nKd 0.25 2 -1\nnewmtl painted\nKd 0.5 0.5 0.5\nmap_Kd t.png\n"
                    "newmtl lost\nKd 0.5 0.5 0.5\nmap_Kd nowhere.png\n");
    workspace_write(&work, "m.obj",
                    "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl plain\nf 1/1 2/1 3/1\n"
                    "usemtl painted\nf 1/1 3/1 2/1\nusemtl lost\nf 2/1 3/1 1/1\n");
    write_bytes("t.png", mesh_file_png, sizeof mesh_file_png);
    mesh m = read_good("m.obj");
    assert_int_equal(m.triangle_count, 3);
    /* The texture: one pixel of sRGB 255 188 0, one of 0 188 0: linear means 0.5, 0.50289, 0. */
    static const float expected[3][3] = {{0.25F, 1, 0}, {0.25F, 0.25144F, 0}, {0.5F, 0.5F, 0.5F}};
    for (size_t t = 0; t < 3; t++)
        for (size_t c = 0; c < 3; c++) {
            float albedo = m.albedos[3 * m.materials[t] + c];
            if (!(fabsf(albedo - expected[t][c]) < 1e-5F))
                fail_msg("triangle %zu, channel %zu: %g", t, c, (double)albedo);
        }
    size_t materials = m.material_count;
    mesh_free(&m);

    buffer table = {0};
    buffer_add(&table, "name\tmean_linear_albedo_r\tg\tb\n");
    for (size_t i = 0; i < materials; i++)
        buffer_print(&table, "x\t0.%zu\t0.5\t1\r\n", i + 1);
    workspace_write(&work, "m.materials.tsv", table.text);
    m = read_good("m.obj");
    for (size_t i = 0; i < materials; i++) {
        assert_true(fabsf(m.albedos[3 * i] - 0.1F * (float)(i + 1)) < 1e-6F);
        assert_true(m.albedos[3 * i + 1] == 0.5F && m.albedos[3 * i + 2] == 1);
    }
    mesh_free(&m);
    buffer_add(&table, "x\t0.1\t0.5\t1\n");
    workspace_write(&work, "m.materials.tsv", table.text);
    refused("m.obj", NULL, "no more than");
    workspace_write(&work, "m.materials.tsv", "name\tmean_linear_albedo_r\tg\tb\nx\t0.1\t1.5\t1\n");
    capture c;
    capture_begin(&c);
    assert_false(mesh_read(workspace_path(&work, "m.obj"), NULL, &m));
    assert_one_line(capture_end(&c), "m.materials.tsv", "line 2", "1.5");
    capture_begin(&c);
    workspace_write(&work, "m.materials.tsv", "name\tr\tg\tb\n");
    assert_false(mesh_read(workspace_path(&work, "m.obj"), NULL, &m));
    assert_one_line(capture_end(&c), "m.materials.tsv", "line 1", "mean_linear_albedo_r");
    buffer_free(&table);
}

static void test_refusals(void **state)
{
    (void)state;
    refused("absent.obj", NULL, "cannot read");
    workspace_write(&work, "mesh.txt", "v 0 0 0\n");
    refused("mesh.txt", NULL, ".obj, .ply, .gltf or .glb");
    workspace_write(&work, "empty.obj", "");
    refused("empty.obj", NULL, "an empty file");
    mkdir(workspace_path(&work, "folder.obj"), 0777);
    refused("folder.obj", NULL, "something else");
    mkfifo(workspace_path(&work, "fifo.obj"), 0666); /* opening it would wait for ever */
    refused("fifo.obj", NULL, "something else");
    buffer ply = mesh_file_ply(false, false); /* promises one face more than it has */
    write_bytes("short.ply", ply.text, ply.length);
    refused("short.ply", NULL, "element face: 3 of the 4");
    buffer_free(&ply);
}

/* Two million points take a moment: longer than the limit, or more memory than it. */
static void test_limits(void **state)
{
    (void)state;
    buffer big = {0};
    for (int i = 0; i < 300000; i++)
        buffer_add(&big, "v 0.125 0.25 0.5\nv 1 0 0\nf -1 -2 1\n");
    write_bytes("big.obj", big.text, big.length);
    buffer_free(&big);
    refused("big.obj", &(mesh_limits){.seconds = 0.01}, "not read within 0.01 s");
#ifndef __SANITIZE_ADDRESS__
    refused("big.obj", &(mesh_limits){.memory = 1 << 20}, "");
#endif
}

static double seconds(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

/* Reads a damaged file; a mesh that comes back is usable. Counts those that do. */
static void try_damaged(const char *name, const char *bytes, size_t size, int *taken)
{
    static const mesh_limits limits = {.seconds = 3};
    capture c;
    mesh m;
    write_bytes(name, bytes, size);
    double begin = seconds();
    capture_begin(&c);
    bool good = mesh_read(workspace_path(&work, name), &limits, &m);
    const char *text = capture_end(&c);
    assert_true(seconds() - begin < 8);
    *taken += good;
    if (!good)
        assert_one_line(text, name);
    else if (text[0])
        fail_msg("%s was read, but said: %s", name, text);
    for (size_t i = 0; good && i < 3 * m.triangle_count; i++)
        assert_true(m.indices[i] < m.vertex_count);
    for (size_t i = 0; good && i < m.triangle_count; i++)
        assert_true(m.materials[i] < m.material_count);
    mesh_free(&m);
}

/* Cut at every so many bytes, bytes changed, pieces taken out. */
static void damage(const char *name, const buffer *file, int rounds, bool whole_only)
{
    int taken = 0, cut = 0;
    char *bytes = base_allocate(file->length);
    size_t step = file->length / 25 + 1;
    for (size_t size = 1; size + 2 < file->length; size += step)
        try_damaged(name, file->text, size, &cut);
    if (whole_only && cut > 0)
        fail_msg("%s: %d cut files were taken for whole ones", name, cut);
    for (int i = 0; i < rounds; i++) {
        size_t size = file->length;
        memcpy(bytes, file->text, size);
        for (size_t changes = 1 + random_below(3); changes > 0; changes--) {
            /* as often in the last quarter, where the data are, as anywhere */
            size_t at =
                random_below(2) ? random_below(size) : size - 1 - random_below(size / 4 + 1);
            size_t length = 1 + random_below(size - at);
            if (random_below(8) == 0) {
                memmove(bytes + at, bytes + at + length, size - at - length);
                size = size - length > 0 ? size - length : 1;
            } else if (random_below(2)) {
                bytes[at] = (char)(bytes[at] ^ (1 << random_below(8)));
            } else {
                bytes[at] = (char)random_below(256);
            }
        }
        try_damaged(name, bytes, size, &taken);
    }
    print_message("%s: %d of %d damaged ones can be read\n", name, taken, rounds);
    assert_in_range(taken, 1, rounds - 1);
    free(bytes);
}

static void test_damage(void **state)
{
    (void)state;
    random_state = 0x9e3779b97f4a7c15u;
    buffer ply = mesh_file_ply(false, true), binary = mesh_file_ply(true, true),
           glb = mesh_file_glb(1, 0, 0), obj = {0};
    buffer_add(&obj, mesh_file_obj);
    damage("d.ply", &ply, 60, true);
    damage("e.ply", &binary, 60, true);
    damage("d.glb", &glb, 60, true);
    damage("d.obj", &obj, 60, false); /* nothing in the format says where it ends */
    buffer_free(&ply);
    buffer_free(&binary);
    buffer_free(&glb);
    buffer_free(&obj);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_formats), cmocka_unit_test(test_nodes),
        cmocka_unit_test(test_albedos), cmocka_unit_test(test_refusals),
        cmocka_unit_test(test_limits),  cmocka_unit_test(test_damage)};
    return cmocka_run_group_tests(tests, open_work, close_work);
}
