// What a reader of JSON text hears, in the three kinds that a tree is built from: a value, the beginning and the end of
// a container.
#pragma once

#include <nlohmann/json.hpp>
#include <utility>

namespace torrance {

/// `Tree` is a type of JSON values: nlohmann's own, or one that keeps the order of members.
template <typename Tree>
class JsonEvents : public nlohmann::json_sax<Tree>
{
    using Sax = nlohmann::json_sax<Tree>;

public:
    bool null() final { return add(nullptr); }
    bool boolean(bool value) final { return add(value); }
    bool number_integer(typename Sax::number_integer_t value) final { return add(value); }
    bool number_unsigned(typename Sax::number_unsigned_t value) final { return add(value); }
    bool number_float(typename Sax::number_float_t value, const typename Sax::string_t&) final { return add(value); }
    bool string(typename Sax::string_t& value) final { return add(std::move(value)); }
    bool binary(typename Sax::binary_t&) final { return false; } // not part of JSON text
    bool start_object(std::size_t) final { return open(Tree::object()); }
    bool start_array(std::size_t) final { return open(Tree::array()); }
    bool end_object() final { return close(); }
    bool end_array() final { return close(); }

protected:
    virtual bool add(Tree&& value) = 0;
    virtual bool open(Tree&& container) = 0; // empty
    virtual bool close() = 0;
};

} // namespace torrance
