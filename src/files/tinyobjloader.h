// tinyobjloader with its warnings off. Its implementation is compiled in tinyobjloader.cpp.
#pragma once

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wshadow"
#include <tiny_obj_loader.h>
#pragma GCC diagnostic pop

#include <istream>
#include <string_view>

namespace torrance {

/// A stream over text that stays where it is.
class ViewStream : private std::streambuf, public std::istream
{
public:
    explicit ViewStream(std::string_view text) : std::istream(static_cast<std::streambuf*>(this))
    {
        char* first = const_cast<char*>(text.data()); // a stream of input never writes there
        setg(first, first, first + text.size());
    }
};

} // namespace torrance
