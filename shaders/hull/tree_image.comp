#version 450
// tree_image.comp: the nodes of the tree, from the host's buffer, as an image for tree.glsl.

layout(local_size_x = 64) in;

layout(set = 0, binding = 0, std430) readonly buffer Texels
{
    uvec4 texels[];
};
layout(set = 0, binding = 1, rgba32ui) writeonly uniform uimage2D tree_image;

void main()
{
    uint i = gl_GlobalInvocationID.x, across = uint(imageSize(tree_image).x);
    if (i < texels.length())
        imageStore(tree_image, ivec2(i % across, i / across), texels[i]);
}
