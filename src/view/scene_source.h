// The file that a scene was read from, as it was then: edits are edits of that, however often it is written over.
#pragma once

#include "core/content_hash.h"

#include <filesystem>
#include <functional>
#include <optional>

namespace torrance {

class SceneSource
{
public:
    /// Nothing is read yet.
    explicit SceneSource(std::filesystem::path file) : own(std::move(file)) {}
    ~SceneSource();
    SceneSource(const SceneSource&) = delete;
    SceneSource& operator=(const SceneSource&) = delete;

    bool isFile(const std::filesystem::path& file) const; // by whatever path it is named

    /// What the file held, once it was written over; empty before: the file holds it itself.
    const std::filesystem::path& copy() const { return kept; }

    /// Calls `write` with a copy of what the file held, from which it writes the file over. The copy lies in a folder
    /// of its own for temporary files, and stays there until this object goes. Errors: of `write`; cannotWrite, where
    /// there is no place for the copy; input, where somebody else has written the file since it was written here.
    void writeOver(const std::function<void(const std::filesystem::path& copy)>& write);

private:
    void makeCopy();
    void removeCopy();

    std::filesystem::path own, kept;
    std::optional<ContentHash> written; // what the file holds since then
};

} // namespace torrance
