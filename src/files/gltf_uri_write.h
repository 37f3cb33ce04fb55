// URIs for a glTF file that is written.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace torrance {

/// A path as a relative reference: everything but letters, digits, `-._~` and `/` is percent-encoded (RFC 3986, 2.3),
/// so that a colon in it makes no scheme.
std::string percentEncoded(std::string_view path);

/// The reference by which a model in `folder` names `file`. Links in the way to either are followed, `file` itself
/// may be one.
std::string relativeUri(const std::filesystem::path& file, const std::filesystem::path& folder);

/// Whether loading follows a reference only where files outside the model's folder are allowed.
bool leavesTheFolder(std::string_view relativeUri);

/// A data URI, base64.
std::string dataUri(std::span<const std::byte> bytes, std::string_view mimeType);

} // namespace torrance
