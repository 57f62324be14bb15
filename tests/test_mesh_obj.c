/* OBJ files as people write them: read as they are meant, or refused in one line. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "base/buffer.h"
#include "capture.h"
#include "render/mesh.h"
#include "work.h"

static mesh read_good(const char *text)
{
    mesh m;
    workspace_write(&work, "t.obj", text);
    if (!mesh_read(workspace_path(&work, "t.obj"), NULL, &m))
        fail_msg("refused: %s", text);
    return m;
}

/* Each is the triangle (0.5, -0.25, 2), (1, 0, 0), (0, 100, 0), and nothing else. */
static void test_spellings(void **state)
{
    (void)state;
    static const char *const texts[] = {
        "v .5 -.25 2\nv 1 0 0\nv 0 100 0\nf 1 2 3\n",
        "v +.5 -0.25 2.\nv 1 -.0 +0\nv 0 1e2 0\nf 1 2 3\n",
        "v +.5e+00 -25.e-2 002\nv 1.E0 0 0\nv 0 1E002 1e-050\nf +1 02 3\n",
        "v 0.5 -0.25 2000000000000000000000e-21\nv 1 0 0.000\nv 0 100 0\nf 1 2 3\n",
        "v 1 -.5 4 2\nv 1 0 0 1\nv 0 100 0 1.0\nf 1 2 3\n",
        "v .5 -.25 2\nv 1 0 0 .1 .2 .3\nv 0 100 0\nf 1 2 3\n",
        "v .5 -.25 2 1 1 1 1\nv 1 0 0 .1 .2 .3 1\nv 0 100 0 0 0 0 1\nf 1 2 3\n",
        "v\t.5  -.25\t2\t\nv\t1\t0 0 \n  v 0 100 0\n\tf\t1 2\t3  \n",
        "v .5 -.25 2\r\nv 1 0 0\r\nv 0 100 0 \r\nf 1 2 3\r\n",
        "v .5 -.25 2\rv 1 0 0\rv 0 100 0\rf 1 2 3",
        "\xef\xbb\xbfv .5 -.25 2\nv 1 0 0\nv 0 100 0\nf 1 2 3",
        "v .5 \\\n-.25 2\nv 1 0 0\nv 0 100 \\\r\n 0\nf 1 \\\n2 \\\n3\n",
        "# C:\\x\\\nv .5 -.25 2 # one\nv 1 0 0# two\nv 0 100 0 #\nf 1 2 3 # 2\n",
        "f 1 2 3\nv .5 -.25 2\nv 1 0 0\nv 0 100 0\n",
        "v 9 9 9\nv .5 -.25 2\nv 1 0 0\nv 0 100 0\nf -3 -2 -1\nv 8 8 8\n",
        "v .5 -.25 2\nv 1 0 0\nv 0 100 0\nvn 0 0 1\nvt .5\nf 1/1 2/1 3/1\n",
        "v .5 -.25 2\nv 1 0 0\nv 0 100 0\nvn 0 0 1\nf 1//1 2//-1 3//1\n",
    };
    static const float expected[9] = {0.5F, -0.25F, 2, 1, 0, 0, 0, 100, 0};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        mesh m = read_good(texts[i]);
        if (m.triangle_count != 1 || m.left_out != 0)
            fail_msg("%zu triangles of: %s", m.triangle_count, texts[i]);
        for (size_t k = 0; k < 9; k++) {
            float x = m.positions[3 * m.indices[k / 3] + k % 3];
            if (!(fabsf(x - expected[k]) < 1e-6F))
                fail_msg("corner %zu, %zu: %g of: %s", k / 3, k % 3, (double)x, texts[i]);
        }
        mesh_free(&m);
    }
}

/* A normal goes to the corner that names it, and to none where one corner names none. */
static void test_normals(void **state)
{
    (void)state;
    mesh m = read_good("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0\nvn .6 0 .8\nvn 0 1 .0\n"
                       "f 1/1/2 2//1 3/1/1\nf 1//1 2 4//2\n");
    assert_int_equal(m.triangle_count, 2);
    static const float expected[6][3] = {{0, 1, 0}, {0.6F, 0, 0.8F}, {0.6F, 0, 0.8F}};
    for (size_t k = 0; k < 6; k++)
        for (size_t c = 0; c < 3; c++)
            assert_true(fabsf(m.normals[3 * m.indices[k] + c] - expected[k][c]) < 1e-6F);
    mesh_free(&m);
}

/* A polygon with a notch has the same area, 2.3, whatever the unit, and joined vertices are those
 * at one place. */
static void test_polygons(void **state)
{
    (void)state;
    static const float units[] = {1e6F, 1, 1e-3F, 1e-6F, 1e-12F};
    for (size_t i = 0; i < sizeof units / sizeof *units; i++) {
        const double unit = (double)units[i];
        buffer text = {0};
        buffer_print(&text, "v 0 0 0\nv %g 0 0\nv %g %g 0\nv %g %g 0\nv 0 %g 0\nf 1 2 3 4 5\n",
                     2 * unit, 2 * unit, 2 * unit, unit, 0.3 * unit, 2 * unit);
        mesh m = read_good(text.text);
        assert_int_equal(m.triangle_count, 3);
        assert_int_equal(m.vertex_count, 5);
        double area = 0;
        for (size_t t = 0; t < 3; t++) {
            const float *p[3];
            for (size_t k = 0; k < 3; k++)
                p[k] = &m.positions[3 * m.indices[3 * t + k]];
            area += 0.5 * ((double)(p[1][0] - p[0][0]) * (double)(p[2][1] - p[0][1]) -
                           (double)(p[1][1] - p[0][1]) * (double)(p[2][0] - p[0][0]));
        }
        if (!(fabs(area / (unit * unit) - 2.3) < 1e-5))
            fail_msg("unit %g: area %g", unit, area / (unit * unit));
        mesh_free(&m);
        buffer_free(&text);
    }
}

static void test_refusals(void **state)
{
    (void)state;
    static const char *const cases[][3] = {
        {"v 0 0 0\nv 1e 0 0\nf 1 1 1\n", "line 2", "expected a number, found 1e"},
        {"v 0 0 0\nv 1 1,5 0\nf 1 1 1\n", "line 2", "1,5"},
        {"v 0 0 0\n\n# \\\nv 0 . 0\nf 1 1 1\n", "line 4", "found ."},
        {"v 0 0 0x1\nf 1 1 1\n", "line 1", "0x1"},
        {"v 0 0 0\r\nv 0 1\r\nf 1 1 1\n", "line 2", "behind v, found 2"},
        {"v 0 0 \\\n0\nv 0 1 0 0 0\nf 1 1 1\n", "line 3", "behind v, found 5"},
        {"v 0 0 0\nvn 0 1\nf 1 1 1\n", "line 2", "behind vn, found 2"},
        {"v 0 0 0\nf 1 1 0\n", "line 2", "found 0"},
        {"v 0 0 0\nf 1 1.0 1\n", "line 2", "found 1.0"},
        {"v 0 0 0\nf 1 -2 1\n", "line 2", "found -2"},
        {"v 0 0 0\nf 1 1 4\nf 1 1 3\n", "line 2", "up to 1, the number of vertices, found 4"},
        {"v 0 0 0\nf 1//1 1 1\n", "line 2", "the number of normals, found 1"},
        {"v 0 0 0\nv 1 1 1\n", "no faces", ""},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        capture c;
        mesh m;
        workspace_write(&work, "r.obj", cases[i][0]);
        capture_begin(&c);
        bool good = mesh_read(workspace_path(&work, "r.obj"), NULL, &m);
        const char *said = capture_end(&c);
        if (good)
            fail_msg("taken: %s", cases[i][0]);
        assert_one_line(said, "r.obj", cases[i][1], cases[i][2]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_spellings), cmocka_unit_test(test_normals),
        cmocka_unit_test(test_polygons), cmocka_unit_test(test_refusals)};
    return cmocka_run_group_tests(tests, open_work, close_work);
}
