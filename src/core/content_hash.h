// A 128-bit hash of content (XXH3), for cache keys and for naming what was drawn. Not for secrets.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace torrance {

struct ContentHash
{
    std::uint64_t high = 0;
    std::uint64_t low = 0;

    bool operator==(const ContentHash&) const = default;
    std::string hex() const; // 32 lower-case digits
};

ContentHash hashBytes(std::span<const std::byte> bytes);
ContentHash hashText(std::string_view text);

/// Fed piece by piece; the order of the pieces counts, and each piece's length is hashed with it.
class ContentHasher
{
public:
    ContentHasher();
    ~ContentHasher();
    ContentHasher(ContentHasher&& other) noexcept : state(std::exchange(other.state, nullptr)) {} // to be fed no more
    ContentHasher(const ContentHasher&) = delete;
    ContentHasher& operator=(const ContentHasher&) = delete;

    ContentHasher& add(std::span<const std::byte> bytes);
    ContentHasher& add(std::string_view text);
    template <typename T>
    requires std::is_arithmetic_v<T> || std::is_enum_v<T> ContentHasher& add(T value)
    {
        return add(std::as_bytes(std::span(&value, 1)));
    }
    /// A part of a piece: its length is not hashed, so that the hash of parts alone is hashBytes of their whole.
    ContentHasher& addPart(std::span<const std::byte> bytes);
    ContentHash finish() const;

private:
    void* state;
};

} // namespace torrance
