// What libpng makes of a file by its own plain reading, one row at a time: what the short way is held against.
#pragma once

#include "scene/texture.h"

#include <bit>
#include <csetjmp>
#include <cstring>
#include <png.h>
#include <string>

namespace torrance::test {

struct LibpngResult
{
    bool read = false;
    int warnings = 0; // of files that were read all the same
    std::string problem;
    TextureImage image;
};

struct LibpngState
{
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::string bytes;
    std::size_t next = 0;
    LibpngResult result;
    std::vector<png_bytep> rows;

    ~LibpngState() { png_destroy_read_struct(&png, &info, nullptr); }
};

inline void readFromString(png_structp png, png_bytep to, std::size_t count)
{
    auto* state = static_cast<LibpngState*>(png_get_io_ptr(png));
    if (count > state->bytes.size() - state->next)
        png_error(png, "the file ends too early");
    std::memcpy(to, state->bytes.data() + state->next, count);
    state->next += count;
}

inline void countWarning(png_structp png, png_const_charp)
{
    ++static_cast<LibpngState*>(png_get_error_ptr(png))->result.warnings;
}

inline void keepProblem(png_structp png, png_const_charp message)
{
    static_cast<LibpngState*>(png_get_error_ptr(png))->result.problem = message;
    png_longjmp(png, 1);
}

// Steps of one reading; false where libpng left by longjmp.
inline bool libpngHeader(LibpngState& state)
{
    if (setjmp(png_jmpbuf(state.png)) != 0)
        return false;
    state.info = png_create_info_struct(state.png);
    png_set_read_fn(state.png, &state, readFromString);
    png_set_keep_unknown_chunks(state.png, PNG_HANDLE_CHUNK_NEVER,
                                reinterpret_cast<const png_byte*>("gAMA\0cHRM\0iCCP\0sRGB\0tEXt"), 5);
    png_read_info(state.png, state.info);
    png_set_expand(state.png);
    png_set_gray_to_rgb(state.png);
    const bool wide = png_get_bit_depth(state.png, state.info) == 16;
    png_set_add_alpha(state.png, wide ? 0xffff : 0xff, PNG_FILLER_AFTER);
    if (wide && std::endian::native == std::endian::little)
        png_set_swap(state.png);
    png_set_interlace_handling(state.png);
    png_read_update_info(state.png, state.info);
    return true;
}

inline bool libpngRows(LibpngState& state)
{
    if (setjmp(png_jmpbuf(state.png)) != 0)
        return false;
    png_read_image(state.png, state.rows.data());
    png_read_end(state.png, nullptr);
    return true;
}

inline LibpngResult readByLibpng(const std::string& bytes)
{
    LibpngState state;
    state.bytes = bytes;
    state.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &state, keepProblem, countWarning);
    if (!libpngHeader(state))
        return state.result;
    TextureImage& image = state.result.image;
    image.width = static_cast<int>(png_get_image_width(state.png, state.info));
    image.height = static_cast<int>(png_get_image_height(state.png, state.info));
    image.format = png_get_bit_depth(state.png, state.info) == 16 ? TexelFormat::rgba16 : TexelFormat::rgba8;
    const std::size_t rowBytes = png_get_rowbytes(state.png, state.info);
    image.texels.resize(rowBytes * static_cast<std::size_t>(image.height));
    for (int y = 0; y < image.height; ++y)
        state.rows.push_back(reinterpret_cast<png_bytep>(image.texels.data()) + static_cast<std::size_t>(y) * rowBytes);
    state.result.read = libpngRows(state);
    return state.result;
}

} // namespace torrance::test
