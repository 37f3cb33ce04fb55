// The table of measured methods that the program is shipped with.
#pragma once

#include "study/method_table_file.h"

#include <fstream>
#include <sstream>

namespace torrance::test {

inline MethodTable shippedTable()
{
    std::ostringstream text;
    text << std::ifstream(TORRANCE_SOURCE_DIR "/assets/methods.measured.json").rdbuf();
    return parseMethodTable(text.str(), "assets/methods.measured.json");
}

} // namespace torrance::test
