// JSON text as a tree that keeps the order of its members: for documents that are edited and written back.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace torrance {

using OrderedJson = nlohmann::ordered_json;

/// Errors (input) and limits as readJson has them.
OrderedJson readOrderedJson(std::string_view text, const std::string& file);

/// The text of a tree, with the indentation that `like` has: none where it is written in one line. Numbers have the
/// digits that read back to the same double; bytes of names that are not UTF-8 are replaced.
std::string orderedJsonText(const OrderedJson& json, std::string_view like);

} // namespace torrance
