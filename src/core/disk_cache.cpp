#include "core/disk_cache.h"

#include "core/atomic_write.h"
#include "core/error.h"
#include "core/log.h"
#include "core/parallel.h"
#include "core/user_folder.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace torrance {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

/// The head of a file. The content follows at contentOffset(), and nothing after it.
struct Header
{
    std::array<char, 8> magic; // its digit is the layout's version
    ContentHash key;
    std::uint64_t size;
    ContentHash checksum; // of the content
};
static_assert(sizeof(Header) == 48);
constexpr std::array<char, 8> kMagic = {'T', 'O', 'R', 'C', 'A', 'C', 'H', '3'};

/// From this size on, content begins on a page of its own, so that it can be mapped.
constexpr std::uint64_t kMappedFrom = 64u << 10;

constexpr std::size_t contentOffset(std::uint64_t size)
{
    return size < kMappedFrom ? sizeof(Header) : kPageBytes;
}

/// A write for every entry that is read would be many: what was used within a day counts as used now.
constexpr auto kUsedLately = 24h;
/// What is being written for longer was left by a process that was ended.
constexpr auto kLongestWrite = 1h;

bool readFully(int file, void* to, std::size_t count)
{
    auto* at = static_cast<std::byte*>(to);
    while (count > 0) {
        const ssize_t n = read(file, at, count);
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0)
            return false;
        at += n;
        count -= static_cast<std::size_t>(n);
    }
    return true;
}

bool readFullyAt(int file, std::byte* to, std::size_t count, off_t offset)
{
    while (count > 0) {
        const ssize_t n = pread(file, to, count, offset);
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0)
            return false;
        to += n;
        offset += n;
        count -= static_cast<std::size_t>(n);
    }
    return true;
}

/// The same on all cores: what is large is copied page by page to memory that nobody has touched yet.
bool readFullyAtOnce(int file, std::span<std::byte> to)
{
    constexpr std::size_t kPiece = 4u << 20; // a core's share of less is read before another has woken up
    if (to.size() < 2 * kPiece)
        return readFully(file, to.data(), to.size());
    const off_t begin = lseek(file, 0, SEEK_CUR);
    std::atomic<bool> whole = begin >= 0;
    parallelFor((to.size() + kPiece - 1) / kPiece, 1, [&](std::size_t i) {
        const std::span<std::byte> piece = to.subspan(i * kPiece, std::min(kPiece, to.size() - i * kPiece));
        if (whole && !readFullyAt(file, piece.data(), piece.size(), begin + static_cast<off_t>(i * kPiece)))
            whole = false;
    });
    return whole && lseek(file, static_cast<off_t>(to.size()), SEEK_CUR) >= 0;
}

/// Closes what is not handed on.
class Descriptor
{
public:
    explicit Descriptor(int file) : number(file) {}
    ~Descriptor()
    {
        if (number >= 0)
            close(number);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int release() { return std::exchange(number, -1); }

    int number;
};

void noteUse(const fs::path& file)
{
    std::error_code ignored; // a folder that cannot be written may still be read
    const auto now = fs::file_time_type::clock::now();
    if (now - fs::last_write_time(file, ignored) > kUsedLately)
        fs::last_write_time(file, now, ignored);
}

bool isKey(std::string_view name)
{
    return name.size() == ContentHash().hex().size() &&
           std::ranges::all_of(name, [](char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; });
}

/// Our entries, and what writeFile makes while it writes one: .<key>.<process>-<number>.
bool isTemporary(std::string_view name)
{
    const std::size_t length = ContentHash().hex().size();
    return name.size() > length + 2 && name[0] == '.' && isKey(name.substr(1, length)) && name[length + 1] == '.';
}

void warnOnce(const std::string& problem)
{
    static std::atomic_flag warned; // all caches lie in one folder: what ails one ails the others
    if (!warned.test_and_set())
        logWarning("the cache is left alone: " + problem);
}

} // namespace

fs::path userCacheFolder()
{
    return userFolder("XDG_CACHE_HOME", ".cache");
}

KeptResult::KeptResult(int file, std::uint64_t size, const ContentHash& checksum)
    : descriptor(file), left(size), expected(checksum)
{
}

KeptResult::KeptResult(KeptResult&& other) noexcept
    : descriptor(std::exchange(other.descriptor, -1)), left(other.left), expected(other.expected),
      hasher(std::move(other.hasher))
{
}

KeptResult::~KeptResult()
{
    if (descriptor >= 0)
        close(descriptor);
}

bool KeptResult::read(std::span<std::byte> to)
{
    if (to.size() > left || !readFullyAtOnce(descriptor, to))
        return false;
    left -= to.size();
    hasher.addPart(to);
    return true;
}

bool KeptResult::isIntact() const
{
    return left == 0 && hasher.finish() == expected;
}

std::optional<MappedFile> KeptResult::map()
{
    constexpr std::size_t kPiece = 1u << 20; // of it that is counted as this process's while it is checked
    if (left < kMappedFrom)
        return std::nullopt;
    auto file = MappedFile::open(descriptor, contentOffset(left), left);
    for (std::size_t at = 0; file && at < file->bytes().size(); at += kPiece) {
        const std::size_t count = std::min(kPiece, file->bytes().size() - at);
        hasher.addPart(file->bytes().subspan(at, count));
        file->release(at, count);
    }
    left = 0;
    return file && isIntact() ? std::move(file) : std::nullopt;
}

std::optional<KeptResult> openResult(const fs::path& file, const ContentHash& key)
{
    Descriptor descriptor(open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)); // of a pipe, do not wait
    struct stat status = {};
    Header header = {};
    if (descriptor.number < 0 || fstat(descriptor.number, &status) != 0 || !S_ISREG(status.st_mode) ||
        !readFully(descriptor.number, &header, sizeof header))
        return std::nullopt;
    const std::uint64_t offset = contentOffset(header.size), whole = static_cast<std::uint64_t>(status.st_size);
    if (header.magic != kMagic || header.key != key || whole < offset || whole - offset != header.size ||
        lseek(descriptor.number, static_cast<off_t>(offset), SEEK_SET) < 0)
        return std::nullopt;
    return KeptResult(descriptor.release(), header.size, header.checksum);
}

void writeResult(const fs::path& file, const ContentHash& key, std::span<const std::span<const std::byte>> parts)
{
    ContentHasher hasher;
    Header header = {.magic = kMagic, .key = key, .size = 0, .checksum = {}};
    for (const auto part : parts) {
        header.size += part.size();
        hasher.addPart(part);
    }
    header.checksum = hasher.finish();
    static constexpr std::array<std::byte, kPageBytes> kNothing{};
    std::vector<std::span<const std::byte>> all = {
        std::as_bytes(std::span(&header, 1)), std::span(kNothing).first(contentOffset(header.size) - sizeof header)};
    all.insert(all.end(), parts.begin(), parts.end());
    writeFile(file, all);
}

DiskCache::DiskCache(fs::path cacheFolder, std::uintmax_t bound) : folder(std::move(cacheFolder)), maxBytes(bound) {}

std::optional<KeptResult> DiskCache::open(const ContentHash& key) const
{
    if (folder.empty())
        return std::nullopt;
    const fs::path path = folder / key.hex();
    std::optional<KeptResult> result = openResult(path, key);
    if (result && result->size() > maxBytes)
        return std::nullopt;
    if (result)
        noteUse(path);
    return result;
}

std::optional<std::vector<std::byte>> DiskCache::load(const ContentHash& key) const
{
    std::optional<KeptResult> result = open(key);
    if (!result)
        return std::nullopt;
    std::vector<std::byte> content(result->size());
    if (!result->read(content) || !result->isIntact())
        return std::nullopt;
    return content;
}

void DiskCache::store(const ContentHash& key, std::span<const std::byte> bytes)
{
    store(key, std::span(&bytes, 1));
}

void DiskCache::store(const ContentHash& key, std::span<const std::span<const std::byte>> parts)
{
    std::uintmax_t size = 0;
    for (const auto part : parts)
        size += part.size();
    size += contentOffset(size);
    if (folder.empty() || size > maxBytes)
        return;
    std::error_code failure;
    fs::create_directories(folder, failure); // each time: somebody may have removed it
    try {
        makeRoom(size);
        writeResult(folder / key.hex(), key, parts);
    } catch (const Error& error) {
        warnOnce(error.what());
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
    const auto now = fs::file_time_type::clock::now();
    std::error_code failure;
    for (fs::directory_iterator it(folder, failure), end; !failure && it != end; it.increment(failure)) {
        const std::string name = it->path().filename().string();
        const bool temporary = isTemporary(name);
        if (!temporary && !isKey(name))
            continue;         // not ours
        std::error_code gone; // another process may have removed it
        const Entry entry = {it->path(), it->last_write_time(gone), it->file_size(gone)};
        if (gone)
            continue;
        if (temporary && now - entry.used > kLongestWrite) {
            fs::remove(entry.path, gone);
            continue;
        }
        total += entry.bytes;
        if (!temporary)
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
