#include "apps/simulate/film.hpp"

#include "analysis/random_draws.hpp"
#include "apps/command_line/errors.hpp"
#include "apps/command_line/record_files.hpp"
#include "apps/record/record_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <numbers>
#include <system_error>
#include <vector>

namespace swirl::apps::simulate {

namespace {

constexpr std::uint64_t stream_of_films = 1;  // of a seed; random starts have 0
constexpr std::size_t piece = std::size_t{1} << 16;

/// Four numbers of the standard normal distribution (Box and Muller 1958), and one that is even from 0 to 1.
struct FrameNoise {
    std::array<double, 4> normal;
    double share;
};

FrameNoise noise_of(std::uint64_t seed, std::int64_t frame) {
    FrameNoise noise{};
    const auto counter = static_cast<std::uint64_t>(frame);
    const auto u = analysis::uniform_draws({counter, 0, 0, 0}, {seed, stream_of_films});
    for (std::size_t pair = 0; pair < 2; ++pair) {
        const double length = std::sqrt(-2 * std::log(u[2 * pair]));
        const double turn = 2 * std::numbers::pi * u[2 * pair + 1];
        noise.normal[2 * pair] = length * std::cos(turn);
        noise.normal[2 * pair + 1] = length * std::sin(turn);
    }
    noise.share = analysis::uniform_draws({counter, 1, 0, 0}, {seed, stream_of_films})[0];
    return noise;
}

std::string created(const FilmOptions& options, const OutputOptions& output, const std::string& scene_file) {
    require_no_input(output.record, {scene_file});
    std::error_code ignored;
    if (options.fps && !output.force && std::filesystem::exists(output.record, ignored))
        throw BadInput(fmt::format("output '{}' exists: name another file, or replace it with --force", output.record));
    return output.record;
}

OutputFile opened(const std::string& name) {
    try {
        return OutputFile(name, "film");
    } catch (const RecordError& error) {  // no work has begun
        throw BadInput(error.what());
    }
}

}  // namespace

void FilmOptions::add_to(Flags& command) {
    const auto number = [&](const char* flag, auto& target, const char* type, const char* help) {
        command.add_option(flag, target, type, help)->group("Film");
    };
    number("--camera", fps, "FPS",
           "write -o FILE.csv in place of a record: what a tracker would, at FPS frames per 1/omega_s (SI units: s)");
    number("--noise", noise, "SIGMA", "of a film: standard deviation of each coordinate, in R_c (SI units: m)");
    number("--lose", lose, "SHARE", "of a film: so many of the frames are lost, 0 <= SHARE < 1");
    number("--pixels", pixels, "P", "of a film: places are in pixels of an image, P to R_c, y down from its corner");
}

void FilmOptions::check(const OutputOptions& output, bool sampled) const {
    if (!fps) {
        if (noise != 0 || lose != 0 || pixels)
            throw BadInput("--noise, --lose and --pixels are a film's: give --camera");
        return;
    }
    const auto require = [](const char* name, double value, bool allowed, const char* range) {
        if (!allowed || !std::isfinite(value))
            throw BadInput(fmt::format("{} = {} is outside its range: {}", name, value, range));
    };
    require("camera", *fps, *fps > 0 && *fps <= 1 / least_sample_step, "more than 0, up to 1e9 frames");
    require("noise", noise, noise >= 0 && noise <= 1e6, "0 to 1e6");
    require("lose", lose, lose >= 0 && lose < 1, "0 <= lose < 1");
    if (pixels) require("pixels", *pixels, *pixels >= 1 && *pixels <= 1e6, "1 to 1e6");
    if (sampled) throw BadInput("--camera and --sample are both given; give one");
    if (output.record.empty()) throw BadInput("--camera writes a film's table: -o FILE.csv is missing");
    if (suffix_of(output.record) == ".h5")
        throw BadInput(fmt::format("output '{}': --camera writes a film's table (text), no record: give -o FILE.csv",
                                   output.record));
}

double Film::step_of(const FilmOptions& options, const std::optional<Units>& units) {
    return without_units(1 / *options.fps, units, "1/omega_s");
}

Film::Film(const FilmOptions& options, const Scene<double>& scene, const SceneOptions& given, std::uint64_t seed,
           const OutputOptions& output)
    : options_(options),
      alpha_(scene.alpha),
      step_(step_of(options, given.units())),
      length_(options.pixels.value_or(given.units().value_or(Units{}).length)),
      corner_(std::ceil(10 * (1.1 + scene.beta)) / 10),
      seed_(seed),
      time_digits_(std::max(3, static_cast<int>(std::ceil(std::log10(*options.fps))) + 1)),
      place_digits_(options.pixels ? 2 : std::max(0, 4 - static_cast<int>(std::floor(std::log10(length_))))),
      file_(opened(created(options, output, given.file()))),
      buffer_("frame,t,x,y,angle,mark_x,mark_y\n") {
    options_.noise = options.pixels ? options.noise : options.noise / length_;
    if (options.pixels && given.units()) options_.noise = options.noise / given.units()->length;
}

void Film::add(const SampleRow& row) {
    const auto frame = static_cast<std::int64_t>(std::llround(row.t / step_));
    const FrameNoise noise = noise_of(seed_, frame);
    if (noise.share < options_.lose) {
        ++lost_;
        return;
    }
    const double sigma = options_.noise;
    const double x = row.x + sigma * noise.normal[0], y = row.y + sigma * noise.normal[1];
    const double mark_x = row.x + alpha_ * std::cos(row.angle) + sigma * noise.normal[2];
    const double mark_y = row.y + alpha_ * std::sin(row.angle) + sigma * noise.normal[3];
    const bool image = options_.pixels.has_value();
    const auto across = [&](double place) { return length_ * (image ? corner_ + place : place); };
    const auto up = [&](double place) { return length_ * (image ? corner_ - place : place); };
    const double angle = std::atan2(image ? y - mark_y : mark_y - y, mark_x - x);
    fmt::format_to(std::back_inserter(buffer_), "{},{:.{}f},{:.{}f},{:.{}f},{:.4f},{:.{}f},{:.{}f}\n", frame,
                   static_cast<double>(frame) / *options_.fps, time_digits_, across(x), place_digits_, up(y),
                   place_digits_, angle, across(mark_x), place_digits_, up(mark_y), place_digits_);
    ++written_;
    if (buffer_.size() < piece) return;
    file_.append(buffer_);
    buffer_.clear();
}

void Film::finish() {
    file_.append(buffer_);
    file_.commit();
}

}  // namespace swirl::apps::simulate
