#include "core/disk_cache.h"

#include "core/atomic_write.h"
#include "core/error.h"
#include "core/log.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>

namespace torrance {
namespace {

namespace fs = std::filesystem;

// File: magic, checksum of the content, content. The magic's digit is the layout's version.
constexpr std::array<char, 8> kMagic = {'T', 'O', 'R', 'C', 'A', 'C', 'H', '1'};
constexpr std::size_t kHeaderBytes = kMagic.size() + sizeof(ContentHash);

} // namespace

fs::path userCacheFolder()
{
    if (const char* folder = std::getenv("XDG_CACHE_HOME"); folder && *folder)
        return fs::path(folder) / "torrance";
    if (const char* home = std::getenv("HOME"); home && *home)
        return fs::path(home) / ".cache" / "torrance";
    return {};
}

DiskCache::DiskCache(fs::path cacheFolder, std::uintmax_t bound) : folder(std::move(cacheFolder)), maxBytes(bound) {}

std::optional<std::vector<std::byte>> DiskCache::load(const ContentHash& key) const
{
    if (folder.empty())
        return std::nullopt;
    const fs::path path = folder / key.hex();
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    if (!file)
        return std::nullopt;
    const std::streamoff size = file.tellg();
    if (size < static_cast<std::streamoff>(kHeaderBytes) || static_cast<std::uintmax_t>(size) > maxBytes)
        return std::nullopt;
    std::array<char, kHeaderBytes> header;
    std::vector<std::byte> content(static_cast<std::size_t>(size) - kHeaderBytes);
    file.seekg(0);
    file.read(header.data(), header.size());
    file.read(reinterpret_cast<char*>(content.data()), static_cast<std::streamsize>(content.size()));
    ContentHash checksum;
    std::memcpy(&checksum, header.data() + kMagic.size(), sizeof checksum);
    if (!file || std::memcmp(header.data(), kMagic.data(), kMagic.size()) != 0 || checksum != hashBytes(content))
        return std::nullopt;
    std::error_code ignored;
    fs::last_write_time(path, fs::file_time_type::clock::now(), ignored); // used lately: the last to go
    return content;
}

void DiskCache::store(const ContentHash& key, std::span<const std::byte> bytes)
{
    if (folder.empty() || bytes.size() + kHeaderBytes > maxBytes)
        return;
    const ContentHash checksum = hashBytes(bytes);
    std::vector<std::byte> file(kHeaderBytes + bytes.size());
    std::memcpy(file.data(), kMagic.data(), kMagic.size());
    std::memcpy(file.data() + kMagic.size(), &checksum, sizeof checksum);
    std::ranges::copy(bytes, file.begin() + kHeaderBytes);
    std::error_code failure;
    fs::create_directories(folder, failure);
    try {
        makeRoom(file.size());
        writeFile(folder / key.hex(), file);
    } catch (const Error& error) {
        logWarning(std::string("the cache is left alone: ") + error.what());
        folder.clear();
    }
}

void DiskCache::makeRoom(std::uintmax_t bytes) const
{
    struct Entry
    {
        fs::path path;
        fs::file_time_type used;
        std::uintmax_t bytes;
    };
    std::vector<Entry> entries;
    std::uintmax_t total = bytes;
    std::error_code failure;
    for (fs::directory_iterator it(folder, failure), end; !failure && it != end; it.increment(failure)) {
        std::error_code gone; // another process may have removed it
        const Entry entry = {it->path(), it->last_write_time(gone), it->file_size(gone)};
        if (gone)
            continue;
        total += entry.bytes;
        entries.push_back(entry);
    }
    std::ranges::sort(entries, {}, &Entry::used);
    for (const Entry& entry : entries) {
        if (total <= maxBytes)
            return;
        std::error_code gone;
        fs::remove(entry.path, gone);
        total -= entry.bytes;
    }
}

} // namespace torrance
