// Films of a body that falls on a plate: the files, the body, and the frames of each fall.
#pragma once

#include "analysis/fits/free_arcs.hpp"
#include "apps/command_line/flags.hpp"
#include "apps/fit/dish_film.hpp"
#include "apps/studies/fits/falls_fit.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace swirl::apps::fit {

struct FallsOptions {
    std::vector<std::string> files;
    std::string side;     ///< of the body, as text
    std::string gravity;  ///< as text; empty: the arcs tell it

    void add_to(Flags& command);
    bool given() const { return !files.empty(); }
    /// @throws BadInput for flags of falls without --falls
    void require_none() const;
};

struct FallenBodies {
    std::vector<std::vector<analysis::FilmFrame>> falls;  ///< lengths in the columns' units times --scale, y up
    double period = 0;                                    ///< of the angle
    studies::FallenBody body;
    studies::FallsSetting setting;
    std::size_t rows = 0;  ///< of all files
    bool y_down = false;   ///< y was said to point down in them
    std::vector<std::string> notes;
};

/// Reads each file as read_film() does its one; the flags of columns, shape, angle and vertex are those of a film.
/// @throws BadInput for what read_track() refuses, flags of a dish, a shape that is missing or out of range, a fall
/// with less than `analysis::fewest_frames` frames, a fall that has more than 3 rows and a tenth of its rows in
/// common with another one (it would count twice), falls of which one has frames four times as close as another's, or
/// one falls otherwise than the others (studies::other_fall)
FallenBodies read_falls(FilmOptions& film, const FallsOptions& falls);

}  // namespace swirl::apps::fit
