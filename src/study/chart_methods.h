// The chart of methods while it is being measured: the finished slots in a file, to go on with later.
#pragma once

#include "study/method_table_file.h"
#include "study/method_trials.h"

#include <string>
#include <vector>

namespace torrance {

/// What a page shows of a method, as the page holds it.
struct EncodedPictures
{
    std::string drawn; // PNG in base64; empty where there is none
    std::string error;
};

struct MethodChart
{
    MethodTable table;                     // rows of the finished slots
    std::vector<EncodedPictures> pictures; // of each row
};

bool hasSlot(const MethodChart& chart, brdf::Slot slot);
void addSlot(MethodChart& chart, const MeasuredSlot& slot);

/// Rows that are on the front of their slot and truth, by index: those that nothing cheaper is as good as.
std::vector<bool> frontRows(const MethodTable& table);

/// `inputs` names everything that what is measured depends on, but for the machine's load.
std::string partText(const MethodChart& chart, const std::string& inputs);
/// An Error (input) where the file is damaged or was made from other inputs; `chart` gives all that belongs to no slot.
MethodChart parsePart(std::string_view text, const std::string& file, const std::string& inputs, MethodChart chart);

/// "slot,method,truth,ns_per_pixel,ns_low,ns_high,ratio,ratio_low,ratio_high,mean,rms,worst,flip,noise,front,note", a
/// row a method.
std::string methodsCsv(const MethodTable& table);

} // namespace torrance
