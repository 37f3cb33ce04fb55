// The tone curves that write pictures are those of the registry.
#include "brdf/method.h"
#include "image/tone_curves.h"
#include "image/transfer_curves.h"

#include <gtest/gtest.h>

namespace torrance::brdf {
namespace {

TEST(ToneRows, AreTheCurvesThatPicturesAreWrittenWith)
{
    std::size_t rows = 0;
    for (const Method& method : allMethods()) {
        if (method.slot != Slot::tone)
            continue;
        ++rows;
        const ToneCurve* curve = findToneCurve(method.id);
        ASSERT_NE(curve, nullptr) << method.id;
        EXPECT_EQ(std::get<CurveFormula>(method.formula), curve->exact) << method.id;
    }
    EXPECT_EQ(rows, allToneCurves().size());
}

TEST(ToneRows, TransferRowsAreTheCurvesThatPicturesAreWrittenWith)
{
    std::size_t rows = 0;
    for (const Method& method : allMethods()) {
        if (method.slot != Slot::transfer)
            continue;
        ++rows;
        const TransferCurve* curve = findTransferCurve(method.id);
        ASSERT_NE(curve, nullptr) << method.id;
        EXPECT_EQ(std::get<CurveFormula>(method.formula), curve->exact) << method.id;
    }
    EXPECT_EQ(rows, allTransferCurves().size());
}

} // namespace
} // namespace torrance::brdf
