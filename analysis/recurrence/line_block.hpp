// What the counting of lines keeps: for all blocks of columns, and for one of them.
#pragma once

#include "analysis/recurrence/gaps.hpp"
#include "analysis/recurrence/line_counter.hpp"
#include "analysis/recurrence/line_frame.hpp"
#include "analysis/recurrence/line_kernels.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace swirl::analysis::recurrence::detail {

// What all blocks add to, atomically, for one threshold.
struct Totals {
    std::vector<std::uint64_t> diagonal, vertical, time, diagonal_points;
    std::uint64_t points = 0, points_outside = 0;
    bool main_diagonal = false;  // of a symmetric matrix: all of it is recurrent, or nothing

    explicit Totals(const Shape& shape)
        : diagonal(std::max(Tally::small, std::max(shape.rows, shape.columns) + 1)),
          vertical(shape.vertical ? diagonal.size() : 0),
          time(vertical.size()),
          diagonal_points(std::min(shape.rows, shape.columns)) {}
};

/// What the totals of all blocks come to: both triangles of a symmetric matrix, and its main diagonal. Moves them out.
LineHistograms histograms_of(const Shape& shape, const Settings& settings, Totals& totals);

struct Context {
    Shape shape;
    Settings settings;
    Frame frame;
    std::vector<Totals> totals;  // per threshold
    bool discard_border() const { return settings.border_lines == BorderLines::discarded; }

    bool touches_border(const DiagonalLine& line) const {
        const std::size_t first_row = line.q + line.first - frame.origin, last_row = line.q + line.last - frame.origin;
        if (shape.presences != nullptr)
            return shape.presences->columns.begins_at(line.first) || shape.presences->rows.begins_at(first_row) ||
                   shape.presences->columns.ends_at(line.last) || shape.presences->rows.ends_at(last_row);
        return line.first == 0 || first_row == 0 || line.last + 1 == shape.columns || last_row + 1 == shape.rows;
    }
    /// Lines that touch a gap are found one by one.
    bool enter_all() const { return discard_border() && shape.presences != nullptr; }
    bool counts(const DiagonalLine& line) const { return !discard_border() || !touches_border(line); }
};

// One threshold of one block.
struct BlockCounter {
    std::array<std::vector<std::uint64_t>, 4> ring;  // frames of four consecutive columns
    std::vector<std::uint64_t> open, planes, none;   // planes: of the words from lines_begin on; none: as many, all 0
    std::vector<std::uint32_t> begun, changes;
    std::vector<std::uint64_t> stretch;  // the bits of one run of rows, where there are gaps
    Tally diagonal, vertical, time;
    ShortLines shorts;
    std::vector<DiagonalLine> ended;
    std::uint64_t points = 0, points_outside = 0;

    BlockCounter(const Frame& frame, Totals& totals)
        : open(frame.words, 0),
          planes(plane_count * frame.line_words(), 0),
          none(frame.line_words(), 0),
          begun(frame.line_words() * 64),
          changes(totals.vertical.empty() ? 0 : frame.rows + 72) {
        for (auto& f : ring) f.assign(frame.words, 0);
        diagonal.shared = totals.diagonal;
        vertical.shared = totals.vertical;
        time.shared = totals.time;
    }
    std::uint64_t* column(std::size_t c) { return ring[c & 3].data(); }
};

}  // namespace swirl::analysis::recurrence::detail
