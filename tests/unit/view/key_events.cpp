#include "view/key_events.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

namespace torrance {
namespace {

KeyEvent press(int key, int modifiers = 0)
{
    return {.key = key, .action = GLFW_PRESS, .modifiers = modifiers};
}

KeyEvent release(int key, int modifiers = 0)
{
    return {.key = key, .action = GLFW_RELEASE, .modifiers = modifiers};
}

KeyEvent letter(char c)
{
    return {.character = static_cast<unsigned>(c)};
}

// How many events each picture takes, until none are left.
std::vector<std::size_t> counts(std::deque<KeyEvent> events)
{
    std::vector<std::size_t> result;
    while (!events.empty())
        result.push_back(takeForOnePicture(events).size());
    return result;
}

using Counts = std::vector<std::size_t>;

TEST(KeyEvents, AShortcutWhoseModifierEndsFirstIsSeenWithIt)
{
    // As xdotool and quick hands have it: Ctrl goes up before A does.
    EXPECT_EQ(counts({press(GLFW_KEY_LEFT_CONTROL), press(GLFW_KEY_A, GLFW_MOD_CONTROL),
                      release(GLFW_KEY_LEFT_CONTROL, GLFW_MOD_CONTROL), release(GLFW_KEY_A)}),
              (Counts{2, 2}));
}

TEST(KeyEvents, AModifierDoesNotReachTheKeysBeforeIt)
{
    EXPECT_EQ(counts({press(GLFW_KEY_LEFT), release(GLFW_KEY_LEFT), press(GLFW_KEY_LEFT_SHIFT),
                      press(GLFW_KEY_END, GLFW_MOD_SHIFT)}),
              (Counts{1, 3}))
        << "Left, then Shift+End: what is selected begins where Left went";
}

TEST(KeyEvents, LettersComeTogether)
{
    EXPECT_EQ(counts({press(GLFW_KEY_A), letter('a'), release(GLFW_KEY_A), press(GLFW_KEY_A), letter('a'),
                      press(GLFW_KEY_LEFT_SHIFT), press(GLFW_KEY_B, GLFW_MOD_SHIFT), letter('B')}),
              (Counts{8}));
}

TEST(KeyEvents, ALetterWaitsForWhatMovedTheCursor)
{
    EXPECT_EQ(counts({letter('a'), press(GLFW_KEY_HOME), letter('b')}), (Counts{2, 1}));
}

TEST(KeyEvents, EachPressOfAKeyHasAPicture)
{
    std::deque<KeyEvent> events;
    constexpr std::size_t kPresses = 30;
    for (std::size_t i = 0; i < kPresses; ++i) {
        events.push_back(press(GLFW_KEY_BACKSPACE));
        events.push_back(release(GLFW_KEY_BACKSPACE));
    }
    std::size_t presses = 0;
    for (std::size_t pictures = 0; !events.empty(); ++pictures) {
        ASSERT_LE(pictures, kPresses);
        std::size_t inPicture = 0;
        for (const KeyEvent& event : takeForOnePicture(events))
            inPicture += event.action == GLFW_PRESS ? 1 : 0;
        EXPECT_LE(inPicture, 1u);
        presses += inPicture;
    }
    EXPECT_EQ(presses, kPresses);
}

TEST(KeyEvents, AKeyThatIsHeldIsNotWaitedFor)
{
    EXPECT_EQ(counts({press(GLFW_KEY_LEFT), press(GLFW_KEY_UP), release(GLFW_KEY_DOWN)}), (Counts{3}));
    EXPECT_TRUE(counts({}).empty());
}

} // namespace
} // namespace torrance
