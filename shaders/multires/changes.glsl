// changes.glsl: the 64 points of a light as squares on a board of 8 x 8, a bit each: row by row from
// bit 0, which is where lib/render/shadows_points.c puts them on a parallelogram.
#ifndef CHANGES_GLSL
#define CHANGES_GLSL

// The point on a square: 16 s + 4 y + x is on one of the 2 x 2 squares at x, y of the 4 x 4 of
// those, on another one for each of the four sets s.
uint point_on(uint square)
{
    uint x = square >> 1 & 3u, y = square >> 4, cell = (square & 1u) | (square >> 2 & 2u);
    return ((cell - x - 2u * y) & 3u) * 16u + 4u * y + x;
}

uint count_squares(uvec2 board)
{
    return uint(bitCount(board.x) + bitCount(board.y));
}

// Of a board that is not empty.
uint first_square(uvec2 board)
{
    return uint(findLSB(board.x != 0u ? board.x : board.y)) + (board.x != 0u ? 0u : 32u);
}

uvec2 without_first(uvec2 board)
{
    return board.x != 0u ? uvec2(board.x & (board.x - 1u), board.y)
                         : uvec2(0u, board.y & (board.y - 1u));
}

// The squares of a set of 16 points.
uvec2 squares_of(uint set)
{
    uvec2 board = uvec2(0u);
    for (uint i = 0u; i < 64u; i++)
        board[i >> 5] |= point_on(i) >> 4 == set ? 1u << (i & 31u) : 0u;
    return board;
}

// A board's squares and the eight around each.
uvec2 widen(uvec2 board)
{
    uvec2 wide = board | (board << 1 & 0xfefefefeu) | (board >> 1 & 0x7f7f7f7fu);
    return wide | uvec2(wide.x << 8, wide.y << 8 | wide.x >> 24)
           | uvec2(wide.x >> 8 | wide.y << 24, wide.y >> 8);
}

// Squares beside one of the other kind.
uvec2 beside_changes(uvec2 board)
{
    return widen(board) & widen(~board);
}

#endif
