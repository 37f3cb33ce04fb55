#include "prepare/word_codec.h"

#include "prepare/texel_kinds.h"
#include "shaders/shared/texel_words.h"

#include <cmath>

namespace torrance {
namespace {

using namespace texels;

using Word = std::uint32_t __attribute__((vector_size(16)));

/// Four fields, by channel.
using Fields = std::array<std::uint32_t, 4>;

/// The fields of a part, and where they are.
struct ColorPart : Colors<Color8Storage, false>
{
    static constexpr Fields kGreatest = {shared::kColorField, shared::kColorField, shared::kColorField,
                                         shared::kMetallicField};
    static constexpr bool kSquareRoots = true;

    static Word word(const Fields& f)
    {
        return Word{f[0] | f[1] << shared::kColorBits, f[2], f[3] << shared::kMetallicShift, 0};
    }
};

struct NormalPart : Normals<std::uint8_t, false>
{
    static constexpr Fields kGreatest = {shared::kNormalField, shared::kNormalField, shared::kNormalField,
                                         shared::kRoughnessField};
    static constexpr bool kSquareRoots = false;

    static Word word(const Fields& f)
    {
        return Word{f[3] << shared::kRoughnessShift, 0, f[0] | f[1] << shared::kNormalBits, f[2]};
    }
};

struct EmissivePart : Colors<Color8Storage, false>
{
    static constexpr Fields kGreatest = {shared::kColorField, shared::kColorField, shared::kBlueField,
                                         shared::kOcclusionField};
    static constexpr bool kSquareRoots = true;

    static Word word(const Fields& f)
    {
        return Word{0, f[0] << shared::kColorBits | f[2] << shared::kBlueShift, 0,
                    f[1] << shared::kGreenShift | f[3] << shared::kOcclusionShift};
    }
};

/// The fields of all codes of a file, by channel and code.
template <typename Part>
const std::array<std::vector<std::uint32_t>, 4>& fieldTables()
{
    static const auto tables = [] {
        std::array<std::vector<std::uint32_t>, 4> made;
        for (std::size_t c = 0; c < made.size(); ++c)
            made[c] = tabulated<std::uint8_t, std::uint32_t>([c](std::uint16_t code) {
                const double value = code / 255.0;
                const double root = Part::kSquareRoots && c < 3 ? std::sqrt(srgbDecode(value)) : value;
                return static_cast<std::uint32_t>(std::lround(root * Part::kGreatest[c]));
            });
        return made;
    }();
    return tables;
}

template <typename Part, bool kFirst>
struct WordRows
{
    static void put(const Fields& fields, std::byte* texel)
    {
        Word word = Part::word(fields);
        if (!kFirst) {
            Word before;
            std::memcpy(&before, texel, sizeof before);
            word |= before;
        }
        std::memcpy(texel, &word, sizeof word);
    }
    static void store(const std::byte* codes, std::size_t count, std::byte* texels)
    {
        const auto& of = fieldTables<Part>();
        for (std::size_t i = 0; i < count; ++i) {
            const auto code = codesAt<std::uint8_t>(codes, i);
            put({of[0][code[0]], of[1][code[1]], of[2][code[2]], of[3][code[3]]}, texels + i * sizeof(Word));
        }
    }
    static void encode(const Float4* means, std::size_t count, std::byte* texels)
    {
        Four four;
        for (std::size_t i = 0; i < count; i += four.size()) {
            const std::size_t some = std::min(count - i, four.size());
            std::copy_n(means + i, some, four.begin());
            std::fill(four.begin() + static_cast<std::ptrdiff_t>(some), four.end(), splat(0.0f));
            std::array<Int4, 4> fields = fieldsOf(four);
            for (std::size_t k = 0; k < some; ++k)
                put({std::uint32_t(fields[0][k]), std::uint32_t(fields[1][k]), std::uint32_t(fields[2][k]),
                     std::uint32_t(fields[3][k])},
                    texels + (i + k) * sizeof(Word));
        }
    }

private:
    /// By channel, those of four texels.
    static std::array<Int4, 4> fieldsOf(Four& means)
    {
        transpose(means[0], means[1], means[2], means[3]);
        if constexpr (!Part::kSquareRoots) {
            makeUnit(means[0], means[1], means[2]);
            for (std::size_t c = 0; c < 3; ++c)
                means[c] = means[c] * 0.5f + 0.5f;
        }
        std::array<Int4, 4> fields;
        for (std::size_t c = 0; c < fields.size(); ++c) {
            const Float4 value = clippedToUnit(means[c]);
            fields[c] =
                roundedProduct(Part::kSquareRoots && c < 3 ? squareRoot(value) : value, double(Part::kGreatest[c]));
        }
        return fields;
    }
};

template <typename Part, bool kFirst>
const TexelCodec& wordCodecOf()
{
    using Of = WordRows<Part, kFirst>;
    static constexpr TexelCodec kCodec = {
        TexelStorage::words, 4 * sizeof(std::uint8_t), Rows<Part>::decode, Rows<Part>::halve, Of::store, Of::encode};
    return kCodec;
}

template <typename Part>
const TexelCodec& wordCodecOf(bool first)
{
    return first ? wordCodecOf<Part, true>() : wordCodecOf<Part, false>();
}

} // namespace

const TexelCodec& wordCodec(WordPart part, bool first)
{
    switch (part) {
    case WordPart::baseColor:
        return wordCodecOf<ColorPart>(first);
    case WordPart::normal:
        return wordCodecOf<NormalPart>(first);
    case WordPart::emissive:
        break;
    }
    return wordCodecOf<EmissivePart>(first);
}

} // namespace torrance
