// A part of a file as memory, without a copy of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace torrance {

/// What memory and parts of files that become memory are multiples of. A system with larger pages maps nothing.
inline constexpr std::size_t kPageBytes = 4096;

/// Pages of a regular file, unmapped with their owner. The file may be removed meanwhile, but not shortened. What is
/// written to the memory stays with this process.
class MappedFile
{
public:
    MappedFile() = default;
    MappedFile(MappedFile&& other) noexcept;
    MappedFile& operator=(MappedFile&& other) noexcept;
    ~MappedFile();

    /// `count` bytes from `offset` on, a multiple of kPageBytes. Nothing where the system does not map them.
    static std::optional<MappedFile> open(int descriptor, std::uint64_t offset, std::size_t count);

    std::span<std::byte> bytes() const { return memory; }

    /// Pages from byte `first` on are no longer counted as this process's, until they are touched again: the system
    /// keeps what it read of the file. Only before anything was written to them.
    void release(std::size_t first, std::size_t count) const;

private:
    std::span<std::byte> memory;
};

} // namespace torrance
