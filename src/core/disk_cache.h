// A folder of results that are dear to make, by the hash of what they are made from. Several processes may use it at
// once; a damaged or foreign file is a miss, never an error; the folder stays below a size.
#pragma once

#include "core/content_hash.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace torrance {

/// $XDG_CACHE_HOME/torrance, else ~/.cache/torrance; empty where neither is set.
std::filesystem::path userCacheFolder();

class DiskCache
{
public:
    /// An empty folder name switches the cache off. The folder is made when the first entry is stored.
    DiskCache(std::filesystem::path folder, std::uintmax_t maxBytes);

    /// The bytes stored under the key, whole and unchanged (their checksum is tested), or nothing.
    std::optional<std::vector<std::byte>> load(const ContentHash& key) const;

    /// Keeps the bytes; oldest entries go where the bound is passed. A folder that cannot be written is warned of once
    /// and then left alone: a cache is never a reason to fail.
    void store(const ContentHash& key, std::span<const std::byte> bytes);

private:
    void makeRoom(std::uintmax_t bytes) const;

    std::filesystem::path folder;
    std::uintmax_t maxBytes;
};

} // namespace torrance
