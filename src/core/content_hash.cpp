#include "core/content_hash.h"

#include <cstdio>
#include <new>
#include <xxhash.h>

namespace torrance {

std::string ContentHash::hex() const
{
    char text[33];
    std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(high),
                  static_cast<unsigned long long>(low));
    return text;
}

ContentHash hashBytes(std::span<const std::byte> bytes)
{
    const XXH128_hash_t h = XXH3_128bits(bytes.data(), bytes.size());
    return {h.high64, h.low64};
}

ContentHash hashText(std::string_view text)
{
    return hashBytes(std::as_bytes(std::span(text)));
}

ContentHasher::ContentHasher() : state(XXH3_createState())
{
    if (!state)
        throw std::bad_alloc();
    XXH3_128bits_reset(static_cast<XXH3_state_t*>(state));
}

ContentHasher::~ContentHasher()
{
    XXH3_freeState(static_cast<XXH3_state_t*>(state));
}

ContentHasher& ContentHasher::add(std::span<const std::byte> bytes)
{
    const std::uint64_t size = bytes.size();
    XXH3_128bits_update(static_cast<XXH3_state_t*>(state), &size, sizeof size);
    return addPart(bytes);
}

ContentHasher& ContentHasher::addPart(std::span<const std::byte> bytes)
{
    XXH3_128bits_update(static_cast<XXH3_state_t*>(state), bytes.data(), bytes.size());
    return *this;
}

ContentHasher& ContentHasher::add(std::string_view text)
{
    return add(std::as_bytes(std::span(text)));
}

ContentHash ContentHasher::finish() const
{
    const XXH128_hash_t h = XXH3_128bits_digest(static_cast<const XXH3_state_t*>(state));
    return {h.high64, h.low64};
}

} // namespace torrance
