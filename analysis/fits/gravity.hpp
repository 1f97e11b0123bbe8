// Gravity, and the drag on top of it, from films of bodies that fall, bounce, and at last lie still.
#pragma once

#include "analysis/fits/floor_drag.hpp"
#include "analysis/fits/free_arcs.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace swirl::analysis {

/// Gravity from frames alone, before any arc is known: the acceleration along y that the most short smooth stretches of
/// frames share, to a tenth: free ones have one, bodies that strike or roll many. y may point down. Nothing where no
/// stretches bend. O(frames log frames).
///   straight  of those frames, without gravity
std::optional<Eigen::Vector2d> first_gravity(const FilmArcs& straight);

/// How free bodies move.
struct FallModel {
    Eigen::Vector2d gravity = Eigen::Vector2d::Zero();
    Drags drags;
};

struct FallFit {
    FallModel model;                                         ///< drags that are not sure are 0
    Eigen::Vector2d error = Eigen::Vector2d::Constant(nan);  ///< standard error of g; 0 where it is given
    DragFit drag, spin;                                      ///< γ and γ_r; NaN: they can't be told
    std::vector<FallModel> moved;  ///< by its errors: independent steps, of one standard error each, that span them
    std::size_t arcs = 0;          ///< that count
};

/// g and γ by least squares over the places of all arcs of `fewest_falling_frames` or more, an A and B of each
/// projected out (variable projection, Gauss–Newton), the frames next to either end left out; Tukey's biweight over the
/// arcs, from the arcs' own g on: a body that rolls or rests is in no free arc. γ_r by the angles of those arcs. Where
/// γ is not surely above 0 (DragFit::surely_drags), g is that without a drag. Errors are the larger ones of those of
/// the noise and of how arcs scatter, longer for few arcs as Student's interval is. Nothing with fewer arcs than
/// `fewest_falling`. O(frames).
///   is_given  the arcs' gravity is kept;   counts  of each arc; empty: all
std::optional<FallFit> fit_fall(const FilmArcs& film, bool is_given, const std::vector<bool>& counts = {});
inline constexpr std::size_t fewest_falling = 3;
inline constexpr std::size_t fewest_falling_frames = 6;

struct FallingArcs {
    FallFit fall;
    FilmArcs arcs;  ///< with that model
};

/// Which arcs fall: their frames' own acceleration is that of the film's model within a third of g or, of short
/// arcs, 4 of its errors, at most 0.7 g. A body that rests, slides or rolls falls otherwise, and a parabola through its
/// frames is none of theirs. O(frames).
std::vector<bool> falling_arcs(const FilmArcs& film);

/// Accelerations of arcs beyond those of their model and of noise: where a tracked centre is not the body's, a lens
/// bends or errors of neighbouring frames go together, velocities at an arc's ends are off by half its time of these.
/// Robust standard deviations over the arcs that count, of x and y alike and of θ, less what noise does; 0 where
/// they are not surely (3 errors) more than noise. O(frames).
Eigen::Vector3d unmodelled_accelerations(const FilmArcs& film, const std::vector<bool>& counts);

/// What is known beforehand.
struct FallSettings {
    std::optional<Eigen::Vector2d> gravity = {};
    std::optional<FallModel> start = {};  ///< from which to look
    Eigen::Vector3d least_noise = Eigen::Vector3d::Zero(), division_noise = Eigen::Vector3d::Zero();  ///< ArcOptions
};

/// The model and arcs in turn until it stays. Nothing where no g is found.
std::optional<FallingArcs> settled_fall(std::span<const FilmFrame> frames, double period, const FallSettings& settings);

}  // namespace swirl::analysis
