#include "analysis/recurrence/lag_lines.hpp"

#include <array>

namespace swirl::analysis::recurrence::detail {
namespace {

// Rows begin ... end - 1.
struct RowLine {
    std::size_t begin, end;
    std::size_t half_length(RecurrenceTime kind) const {
        return kind == RecurrenceTime::midpoints ? (end - begin) / 2 : 0;
    }
};

std::size_t time_between(RecurrenceTime kind, const RowLine& a, const RowLine& b) {
    if (kind == RecurrenceTime::line_starts) return b.begin - a.begin;
    return b.begin - a.end + a.half_length(kind) + b.half_length(kind);
}

}  // namespace

void join_halves(const LagLineTask& task, std::size_t c, bool centre, const LagLine& lower, const LagLine& upper) {
    std::array<RowLine, 3> lines;
    std::size_t count = 0;
    const auto push = [&](std::size_t begin, std::size_t end) {
        if (count > 0 && lines[count - 1].end == begin)
            lines[count - 1].end = end;
        else
            lines[count++] = {begin, end};
    };
    if (exists(upper)) push(c + 1 - upper.end, c + 1 - upper.begin);
    if (centre) push(c, c + 1);
    if (exists(lower)) push(c + lower.begin, c + lower.end);
    const RecurrenceTime kind = task.settings->recurrence_time;
    for (std::size_t k = 0; k < count; ++k) {
        const bool at_border = lines[k].begin == 0 || lines[k].end == task.points;
        if (task.settings->border_lines == BorderLines::counted || !at_border)
            task.tallies->lines.add(lines[k].end - lines[k].begin);
        if (k > 0) task.tallies->times.add(time_between(kind, lines[k - 1], lines[k]));
    }
    if (upper.mark != no_line.mark)
        task.tallies->times.add(lines[0].begin + upper.mark - (c + 1) + lines[0].half_length(kind));
    if (lower.mark != no_line.mark) {
        const RowLine& last = lines[count - 1];
        const std::size_t from = kind == RecurrenceTime::line_starts ? last.begin : last.end;
        task.tallies->times.add(c + lower.mark - from + last.half_length(kind));
    }
    if (!task.settings->border_white_lines) return;
    if (count == 0) return task.tallies->times.add(task.points);
    if (!exists(upper) && lines[0].begin > 0) task.tallies->times.add(lines[0].begin);
    if (!exists(lower) && lines[count - 1].end < task.points)
        task.tallies->times.add(task.points - lines[count - 1].end);
}

}  // namespace swirl::analysis::recurrence::detail
