// The lists of extensions of a document that was edited.
#pragma once

#include "files/json_ordered.h"

#include <set>
#include <string>

namespace torrance {

/// Which of the extensions that editing materials adds or takes away are in use somewhere in the document.
std::set<std::string> editableExtensionsIn(const OrderedJson& document);

/// Brings extensionsUsed and extensionsRequired up to date after an edit; `before` is what was in use before it:
/// new ones are listed, those whose last use went are not. Other names, and names that were listed without a use, stay.
void updateExtensionLists(OrderedJson& document, const std::set<std::string>& before);

/// Lists an extension that the document cannot be read without.
void requireExtension(OrderedJson& document, const std::string& name);

} // namespace torrance
