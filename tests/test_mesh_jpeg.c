/* JPEG textures: their mean, and damage that must end in nothing worse than no texture. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "render/mesh.h"
#include "render/mesh_jpeg.h"
#include "work.h"

/* One grey pixel, 188: linear .50289. */
static const uint8_t grey[] = {
    0xff, 0xd8, 0xff, 0xe0, 0x00, 0x10, 0x4a, 0x46, 0x49, 0x46, 0x00, 0x01, 0x01, 0x00, 0x00, 0x01,
    0x00, 0x01, 0x00, 0x00, 0xff, 0xdb, 0x00, 0x43, 0x00, 0x08, 0x06, 0x06, 0x07, 0x06, 0x05, 0x08,
    0x07, 0x07, 0x07, 0x09, 0x09, 0x08, 0x0a, 0x0c, 0x14, 0x0d, 0x0c, 0x0b, 0x0b, 0x0c, 0x19, 0x12,
    0x13, 0x0f, 0x14, 0x1d, 0x1a, 0x1f, 0x1e, 0x1d, 0x1a, 0x1c, 0x1c, 0x20, 0x24, 0x2e, 0x27, 0x20,
    0x22, 0x2c, 0x23, 0x1c, 0x1c, 0x28, 0x37, 0x29, 0x2c, 0x30, 0x31, 0x34, 0x34, 0x34, 0x1f, 0x27,
    0x39, 0x3d, 0x38, 0x32, 0x3c, 0x2e, 0x33, 0x34, 0x32, 0xff, 0xc0, 0x00, 0x0b, 0x08, 0x00, 0x01,
    0x00, 0x01, 0x01, 0x01, 0x11, 0x00, 0xff, 0xc4, 0x00, 0x14, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x06, 0xff, 0xc4, 0x00, 0x14,
    0x10, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0xff, 0xda, 0x00, 0x08, 0x01, 0x01, 0x00, 0x00, 0x3f, 0x00, 0x78, 0xff, 0xd9,
};

static void write_bytes(const char *name, const uint8_t *bytes, size_t size)
{
    FILE *file = fopen(workspace_path(&work, name), "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    assert_int_equal(fclose(file), 0);
}

static float albedo_with(const uint8_t *texture, size_t size)
{
    mesh m;
    write_bytes("t.jpg", texture, size);
    workspace_write(&work, "m.mtl", "newmtl painted\nKd 0.5 1 1\nmap_Kd t.jpg\n");
    workspace_write(&work, "m.obj",
                    "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl painted\n"
                    "f 1/1 2/1 3/1\n");
    assert_true(mesh_read(workspace_path(&work, "m.obj"), NULL, &m));
    float red = m.albedos[3 * m.materials[0]], green = m.albedos[3 * m.materials[0] + 1];
    assert_true(fabsf(green - 2 * red) < 1e-6F);
    mesh_free(&m);
    return red;
}

static void test_of_a_mesh(void **state)
{
    (void)state;
    assert_true(fabsf(albedo_with(grey, sizeof grey) - 0.5F * 0.50289F) < 1e-5F);
    /* cut off: the colour alone */
    assert_true(fabsf(albedo_with(grey, sizeof grey - 6) - 0.5F) < 1e-6F);
    assert_true(fabsf(albedo_with(grey, 3) - 0.5F) < 1e-6F);
}

static void test_texels(void **state)
{
    (void)state;
    uint8_t *texels;
    size_t count;
    assert_true(mesh_jpeg(grey, sizeof grey, 1, &texels, &count));
    assert_int_equal(count, 1);
    assert_true(texels[0] == 188 && texels[1] == 188 && texels[2] == 188 && texels[3] == 255);
    free(texels);
    assert_false(mesh_jpeg(grey, sizeof grey, 0, &texels, &count)); /* too long a side */
}

/* Every prefix, and every byte wrong in turn: texels or nothing, under the sanitizers as well. */
static void test_damage(void **state)
{
    (void)state;
    uint8_t *texels, bytes[sizeof grey];
    size_t count;
    for (size_t size = 0; size < sizeof grey - 4; size++) {
        assert_false(mesh_jpeg(grey, size, 64, &texels, &count));
        assert_null(texels);
    }
    size_t read = 0;
    for (size_t at = 0; at < sizeof grey; at++)
        for (int wrong = 0; wrong < 3; wrong++) {
            memcpy(bytes, grey, sizeof grey);
            bytes[at] = (uint8_t)(wrong == 0 ? 0 : wrong == 1 ? 0xff : bytes[at] ^ 0x10);
            bool good = mesh_jpeg(bytes, sizeof bytes, 64, &texels, &count);
            read += good;
            assert_true(good == (texels != NULL));
            free(texels);
        }
    assert_true(read > 0 && read < 3 * sizeof grey);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_of_a_mesh),
        cmocka_unit_test(test_texels),
        cmocka_unit_test(test_damage),
    };
    return cmocka_run_group_tests(tests, open_work, close_work);
}
