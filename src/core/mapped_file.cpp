#include "core/mapped_file.h"

#include <cassert>
#include <sys/mman.h>
#include <unistd.h>
#include <utility>

namespace torrance {

MappedFile::MappedFile(MappedFile&& other) noexcept : memory(std::exchange(other.memory, {})) {}

MappedFile& MappedFile::operator=(MappedFile&& other) noexcept
{
    std::swap(memory, other.memory);
    return *this;
}

MappedFile::~MappedFile()
{
    if (!memory.empty())
        munmap(memory.data(), memory.size());
}

std::optional<MappedFile> MappedFile::open(int descriptor, std::uint64_t offset, std::size_t count)
{
    assert(offset % kPageBytes == 0);
    if (count == 0 || sysconf(_SC_PAGESIZE) > static_cast<long>(kPageBytes))
        return std::nullopt;
    void* const begin =
        mmap(nullptr, count, PROT_READ | PROT_WRITE, MAP_PRIVATE, descriptor, static_cast<off_t>(offset));
    if (begin == MAP_FAILED)
        return std::nullopt;
    MappedFile file;
    file.memory = {static_cast<std::byte*>(begin), count};
    return file;
}

void MappedFile::release(std::size_t first, std::size_t count) const
{
    assert(first % kPageBytes == 0 && first + count <= memory.size());
    madvise(memory.data() + first, count, MADV_DONTNEED);
}

} // namespace torrance
