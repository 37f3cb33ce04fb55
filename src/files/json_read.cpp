#include "files/json_read.h"

#include "core/error.h"
#include "files/json_events.h"

#include <vector>

namespace torrance {
namespace {

using nlohmann::json;

/// Builds the tree from the parser's events. The parser keeps its own state in a bit array and does not recurse, so
/// that a depth limit here is one everywhere.
class TreeBuilder : public JsonEvents<json>
{
public:
    TreeBuilder(const std::string& fileName, std::size_t mostValues) : file(fileName), most(mostValues) {}

    bool key(string_t& name) override
    {
        if (levels.back().value->contains(name))
            throw inputError(file, path() + "/" + name, "is given twice", "keep one of the two");
        levels.back().key = std::move(name);
        return true;
    }

    bool parse_error(std::size_t position, const std::string& token, const nlohmann::detail::exception& error) override
    {
        constexpr int kNumberOverflow = 406; // nlohmann::json::out_of_range
        if (error.id == kNumberOverflow)
            throw inputError(file, nextPath(), "number " + token + " overflows",
                             "write a number that a double can hold");
        throw inputError(file, nextPath(), "JSON is malformed at byte " + std::to_string(position),
                         "repair or export the file again");
    }

    json root;

private:
    struct Level
    {
        json* value;
        std::string key; // of the member being read, where it is an object
    };

    /// A node's address stays valid while its children are read: its container gets no other child meanwhile.
    json* place(json&& value)
    {
        if (++count > most)
            throw inputError(file, "", "holds more than " + std::to_string(most) + " JSON values",
                             "keep bulk data in buffers");
        if (levels.empty())
            return &(root = std::move(value));
        Level& level = levels.back();
        if (level.value->is_object())
            return &((*level.value)[level.key] = std::move(value));
        level.value->push_back(std::move(value));
        return &level.value->back();
    }

    bool add(json&& value) override
    {
        place(std::move(value));
        return true;
    }

    bool open(json&& value) override
    {
        if (levels.size() >= kMaxJsonDepth)
            throw inputError(file, path(), "is nested more than " + std::to_string(kMaxJsonDepth) + " deep",
                             "flatten the JSON");
        json* const placed = place(std::move(value));
        levels.push_back({placed, ""});
        return true;
    }

    bool close() override
    {
        levels.pop_back();
        return true;
    }

    std::string path() const
    {
        std::string text;
        for (std::size_t i = 0; i + 1 < levels.size(); ++i)
            text += "/" + step(levels[i], 0);
        return text;
    }

    std::string nextPath() const { return levels.empty() ? "/" : path() + "/" + step(levels.back(), 1); }

    /// The member or element being read; `ahead` is 1 where it has not been placed yet.
    static std::string step(const Level& level, std::size_t ahead)
    {
        return level.value->is_object() ? level.key : std::to_string(level.value->size() - 1 + ahead);
    }

    const std::string& file;
    const std::size_t most;
    std::vector<Level> levels;
    std::size_t count = 0;
};

} // namespace

json readJson(std::string_view text, const std::string& file, std::size_t mostValues)
{
    TreeBuilder builder(file, mostValues);
    json::sax_parse(text.begin(), text.end(), &builder);
    return std::move(builder.root);
}

} // namespace torrance
