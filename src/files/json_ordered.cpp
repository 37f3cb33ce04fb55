#include "files/json_ordered.h"

#include "files/json_events.h"
#include "files/json_read.h"

#include <algorithm>
#include <vector>

namespace torrance {
namespace {

/// Builds the tree without looking members up: an ordered object finds one by going through all of them, and a hostile
/// text can have millions in one object.
class OrderedBuilder : public JsonEvents<OrderedJson>
{
public:
    bool key(string_t& text) override
    {
        name = std::move(text);
        return true;
    }
    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override { return false; }

    OrderedJson root;

private:
    using Members = OrderedJson::object_t::Container;

    /// A node's address stays valid while its children are read: its container gets no other child meanwhile.
    OrderedJson* place(OrderedJson&& value)
    {
        if (levels.empty())
            return &(root = std::move(value));
        OrderedJson& parent = *levels.back();
        if (parent.is_array())
            return &parent.get_ref<OrderedJson::array_t&>().emplace_back(std::move(value));
        Members& members = parent.get_ref<OrderedJson::object_t&>();
        return &members.emplace_back(std::move(name), std::move(value)).second;
    }

    bool add(OrderedJson&& value) override
    {
        place(std::move(value));
        return true;
    }

    bool open(OrderedJson&& value) override
    {
        levels.push_back(place(std::move(value)));
        return true;
    }

    bool close() override
    {
        levels.pop_back();
        return true;
    }

    std::vector<OrderedJson*> levels;
    std::string name; // of the member that comes
};

} // namespace

OrderedJson readOrderedJson(std::string_view text, const std::string& file)
{
    readJson(text, file); // refuses what is malformed, given twice or without measure
    OrderedBuilder builder;
    OrderedJson::sax_parse(text.begin(), text.end(), &builder);
    return std::move(builder.root);
}

std::string orderedJsonText(const OrderedJson& json, std::string_view like)
{
    const std::size_t brace = std::min(like.find('{'), like.size());
    const std::size_t line = like.find('\n', brace);
    const std::size_t first = line == std::string_view::npos ? line : like.find_first_not_of(" \t\r\n", line);
    const std::size_t start = first == std::string_view::npos ? first : like.rfind('\n', first) + 1;
    const bool indented = first != std::string_view::npos && first > start;
    return json.dump(indented ? static_cast<int>(first - start) : -1, indented ? like[start] : ' ', false,
                     OrderedJson::error_handler_t::replace);
}

} // namespace torrance
