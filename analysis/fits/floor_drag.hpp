// The drag of a floor that moves on a circle, from how the arcs of a film bend.
#pragma once

#include "analysis/fits/free_arcs.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace swirl::analysis {

/// Frames of one arc, first and last included, that are away from the kinks at its ends.
struct ArcPart {
    std::size_t first = 0, last = 0;
};

/// Of arcs with one of these kinks at either end: frames beyond 4 errors of the kinks' times. (Frames next to a kink
/// are on the arc that they lie nearer to, which bends it.) Of `fewest_bent` frames or more. O(arcs).
std::vector<ArcPart> parts_between(const FilmArcs& film, std::span<const Kink> kinks);
inline constexpr std::size_t fewest_bent = 4;

/// Standard errors to either end of an interval at 95 %.
inline constexpr double sure_drag = 1.959964;

/// By how much Student's interval of n parts is longer at 95 % than the normal one, which takes their scatter for
/// known: 1 + (z² + 1)/(4 (n − 1)), within 3 % of it from 8 on.
double of_few(std::size_t parts);

struct DragFit {
    double value = nan, error = nan;  ///< γ, in 1/time; NaN with fewer parts than `fewest_parts`
    std::size_t parts = 0;

    /// The interval is above 0.
    bool surely_drags() const { return value > sure_drag * error; }
};

/// γ by least squares over the places of all parts, each with an A and B of its own (variable projection,
/// Gauss–Newton), Tukey's biweight over the parts: an impact that was not seen bends its arc more than noise does. The
/// error is the larger one of that of the noise and that of how the parts scatter, longer for few parts as Student's
/// interval is. O(frames).
///   frames  in the laboratory, film.kept of straight arcs;   noise  of x or y in one frame
DragFit fit_drag(std::span<const FilmFrame> frames, std::span<const ArcPart> parts, const FloorMotion& floor,
                 double noise);
inline constexpr std::size_t fewest_parts = 8;

/// γ_r by the angle alone, likewise; NaN as well where its error is more than `widest_spin_drag` over the median part's
/// time, as of bodies that hardly turn.
///   noise  of θ in one frame
DragFit fit_spin_drag(std::span<const FilmFrame> frames, std::span<const ArcPart> parts, double noise);
inline constexpr double widest_spin_drag = 0.5;

/// Which parts of the arcs count.
using PartsOf = std::function<std::vector<ArcPart>(const FilmArcs& arcs)>;

struct DraggedArcs {
    DragFit drag, spin;  ///< γ and γ_r
    FilmArcs arcs;       ///< with their values, of a γ_r that is NaN with γ, and those given where γ is NaN

    Drags values() const;
};

/// γ and γ_r of a film. Arcs under a drag are no straight lines, and straight ones cut them where noise allows it best,
/// so that what is left bends too little: frames are divided anew with the drags that were found (fit_arcs) until these
/// stay.
///   start  arcs of those frames, straight or bent_arcs()
DraggedArcs settled_drag(std::span<const FilmFrame> frames, double period, const FilmArcs& start,
                         const FloorMotion& floor, const PartsOf& parts_of);

/// Arcs of a film of which neither impacts nor the floor's place are known yet. Where arcs bend by more than noise
/// within a few frames, straight ones cut them into pieces, whose ends are no impacts. γ and a floor of any radius and
/// phase, and γ_r, are found by least squares over the pieces themselves, an A and B of each projected out, and frames
/// are divided anew with these while fewer lines do (the least Σ (residuals/σ)² + cost_of_arc · (lines), σ that of
/// `straight`). Pieces too short to bend are those of a noise that is taken for 3, 10, 30 and 100 times as large.
/// Nothing where no bent arcs are better than straight ones. O(rounds × fit_arcs).
///   straight  arcs of those frames without a drag;   rate  of the floor; 0: it stands still
std::optional<FilmArcs> bent_arcs(std::span<const FilmFrame> frames, double period, const FilmArcs& straight,
                                  double rate);

/// By how much more the places of these parts differ from one floor's arcs than from another's: the difference of
/// Σ |residual|² over the parts, each with an A and B of its own and with that floor's γ by the same parts (fit_drag),
/// in units of σ². σ is the noise, or what the better floor leaves of the median part where that is more. Left out are
/// parts to which neither floor comes as near as noise does. The angle says nothing: whatever slows the spin, it is the
/// same on either floor. If `other` is the true one, it exceeds a limit c with a chance of at most Φ(−√c). NaN where a
/// γ can't be told. O(frames).
double floor_worse_by(std::span<const FilmFrame> frames, std::span<const ArcPart> parts, const FloorMotion& floor,
                      const FloorMotion& other, double noise);

}  // namespace swirl::analysis
