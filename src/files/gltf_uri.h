// Where a URI of a glTF file leads: data inside the text, or a file beside it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace torrance {

/// %41 → A. An escape that is not one stays as it is.
std::string percentDecoded(std::string_view text);

/// Whether a URI is relative to its file: no scheme, and no path from the root.
bool isRelativeUri(std::string_view uri);

/// The bytes of a data URI (base64 or percent-encoded), or nothing where `uri` is none. An Error (input) names `file`
/// and `item` where its base64 is damaged.
std::optional<std::vector<std::byte>> dataOfUri(std::string_view uri, const std::string& file, const std::string& item);

/// The file that a relative reference names, seen from `folder`. Unless `allowExternal`, what leaves the folder of the
/// model is refused (`..`, an absolute path, a scheme), judged after percent-decoding, `\` counting as `/`. With it,
/// `file:` is followed; other schemes never are, for nothing is fetched from a network. Errors (input).
std::filesystem::path pathOfUri(std::string_view uri, const std::filesystem::path& folder, bool allowExternal,
                                const std::string& file, const std::string& item);

} // namespace torrance
