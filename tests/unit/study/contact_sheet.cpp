#include "study/contact_sheet.h"

#include <gtest/gtest.h>

namespace torrance {
namespace {

TEST(ContactSheet, PutsPicturesInRowsOnNothing)
{
    const Image pictures[] = {Image(2, 2, 3, 0.25f), Image(2, 2, 3, 0.5f), Image(2, 2, 4, 0.75f)};
    const Image sheet = contactSheet(pictures, 2);
    EXPECT_EQ(sheet.width, 2 + kSheetGap + 2);
    EXPECT_EQ(sheet.height, 2 + kSheetGap + 2);
    EXPECT_EQ(sheet.at(1, 1)[0], 0.25f);
    EXPECT_EQ(sheet.at(1, 1)[3], 1.0f) << "opaque where the picture has no alpha";
    EXPECT_EQ(sheet.at(2, 0)[3], 0.0f) << "the gap";
    EXPECT_EQ(sheet.at(5, 1)[2], 0.5f);
    EXPECT_EQ(sheet.at(0, 5)[3], 0.75f);
    EXPECT_EQ(sheet.at(5, 5)[3], 0.0f) << "the last row is not full";
}

TEST(ContactSheet, EnlargesSmallPicturesByWholeFactors)
{
    Image small(2, 2, 3);
    *small.at(1, 0) = 1.0f;
    const Image pictures[] = {Image(5, 4, 3, 0.5f), small};
    const Image sheet = contactSheet(pictures, 8);
    EXPECT_EQ(sheet.width, 5 + kSheetGap + 5);
    const int left = 5 + kSheetGap;
    for (const int x : {left + 2, left + 3})
        for (const int y : {0, 1})
            EXPECT_EQ(sheet.at(x, y)[0], 1.0f);
    EXPECT_EQ(sheet.at(left + 1, 0)[0], 0.0f);
    EXPECT_EQ(sheet.at(left + 2, 2)[0], 0.0f);
    EXPECT_EQ(sheet.at(left + 4, 0)[3], 0.0f);
}

} // namespace
} // namespace torrance
