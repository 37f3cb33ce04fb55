// A folder of results that are dear to make, by the hash of what they are made from. Several processes may use it at
// once; a damaged or foreign file is a miss, never an error; the folder stays below a size.
#pragma once

#include "core/content_hash.h"
#include "core/mapped_file.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace torrance {

/// $XDG_CACHE_HOME/torrance, else ~/.cache/torrance; empty where neither is set.
std::filesystem::path userCacheFolder();

/// A result in a file, read from front to back in pieces of any size, so that large ones need no memory of their own.
class KeptResult
{
public:
    KeptResult(KeptResult&& other) noexcept;
    KeptResult& operator=(KeptResult&&) = delete;
    ~KeptResult();

    std::uint64_t size() const { return left; } // bytes not read yet

    /// False where there are not so many bytes, or the file fails.
    bool read(std::span<std::byte> to);

    /// After all was read: whether it is what was stored. Until then nothing that was read is to be trusted.
    bool isIntact() const;

    /// In place of reading it: all of it as memory, checked. Nothing where it is not what was stored, where it is too
    /// small to begin on a page of its own, and where the system does not map it.
    std::optional<MappedFile> map();

private:
    friend std::optional<KeptResult> openResult(const std::filesystem::path& file, const ContentHash& key);
    KeptResult(int file, std::uint64_t size, const ContentHash& checksum);

    int descriptor;
    std::uint64_t left;
    ContentHash expected;
    ContentHasher hasher;
};

/// Nothing where the file is not there, is another version's, was stored under another key, or is not of its own
/// length.
std::optional<KeptResult> openResult(const std::filesystem::path& file, const ContentHash& key);

/// Writes a result, whose parts are stored after each other, so that openResult finds it. Throws as writeFile.
void writeResult(const std::filesystem::path& file, const ContentHash& key,
                 std::span<const std::span<const std::byte>> parts);

class DiskCache
{
public:
    /// An empty folder name switches the cache off. The folder is made when the first entry is stored.
    DiskCache(std::filesystem::path folder, std::uintmax_t maxBytes);

    std::optional<KeptResult> open(const ContentHash& key) const;

    /// All bytes stored under the key, whole and unchanged, or nothing.
    std::optional<std::vector<std::byte>> load(const ContentHash& key) const;

    /// Keeps the bytes; oldest entries go where the bound is passed. A folder that cannot be written is left alone from
    /// then on, and the first of a process is warned of: a cache is never a reason to fail.
    void store(const ContentHash& key, std::span<const std::byte> bytes);
    void store(const ContentHash& key, std::span<const std::span<const std::byte>> parts);

private:
    void makeRoom(std::uintmax_t bytes) const;

    std::filesystem::path folder;
    std::uintmax_t maxBytes;
};

} // namespace torrance
