// The orbit as a camera above the dish and a tracker would write it: a text file, a frame a line.
#pragma once

#include "apps/command_line/output_options.hpp"
#include "apps/command_line/scene_options.hpp"
#include "apps/record/output_file.hpp"
#include "apps/simulate/samples.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace swirl::apps::simulate {

struct FilmOptions {
    std::optional<double> fps;     ///< frames per unit of time, or a second where the scene has units; none: no film
    double noise = 0;              ///< standard deviation of each coordinate, in R_c or m
    double lose = 0;               ///< share of the frames that are lost
    std::optional<double> pixels;  ///< R_c is so long in the image, whose y points down

    void add_to(Flags& command);
    /// @throws BadInput for numbers out of range, a film without a file, flags of a film without --camera
    void check(const OutputOptions& output, bool sampled) const;
};

/// Columns frame, t, x, y, angle, mark_x, mark_y: the body's centre, vertex 0 (of a disk, a mark on its rim), and the
/// direction from the one to the other in (−π, π], in the laboratory, seen from above. Both points have noise of their
/// own, from which the angle has its. Times are rounded to a millisecond or, beyond 100 frames, finer by a digit or
/// more, places to 10⁻⁴ R_c or a hundredth of a pixel, angles to 10⁻⁴: a frame is lost, or moved, by random numbers of
/// the seed and the frame's number (Philox), whatever else is filmed.
class Film {
public:
    /// Creates the file. @throws BadInput if that can't be
    Film(const FilmOptions& options, const Scene<double>& scene, const SceneOptions& given, std::uint64_t seed,
         const OutputOptions& output);

    /// 1/fps in 1/ω_s.
    static double step_of(const FilmOptions& options, const std::optional<Units>& units);

    void add(const SampleRow& row);
    void finish();
    std::int64_t written() const { return written_; }
    std::int64_t lost() const { return lost_; }

private:
    FilmOptions options_;
    double alpha_, step_, length_;  ///< R_c in the units of the file
    double corner_;                 ///< of the image, from the swirl's centre, in R_c
    std::uint64_t seed_;
    int time_digits_, place_digits_;
    OutputFile file_;
    std::string buffer_;
    std::int64_t written_ = 0, lost_ = 0;
};

}  // namespace swirl::apps::simulate
