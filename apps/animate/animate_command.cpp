#include "apps/animate/animate_command.hpp"

#include <string>
#include <vector>

namespace swirl::apps::animate {

namespace {

/// A film of a minute takes some minutes to draw.
const scripts::ScriptOutput film{"animate_record.py",     "film", "swirl animate", {".mp4", ".gif"},
                                 "made by swirl animate", 1800};

}  // namespace

const char* const animate_details =
    R"(Shows the body in the swirled container, with S(t) running beside it, from a record of
  simulate   the orbit that it lists; through contact with the wall where it has samples (simulate --sample)
  orbits     one of its cycles over a period (--orbit I, as the table numbers them), also an unstable one, on
             which no orbit stays. The flights follow from the points in the record.
--frame chooses where one stands: container (which is then at rest, and the swirl's centre runs around), laboratory (the
container runs on its circle) or co-rotating (with the swirl: both are at rest, and a steady mode is a closed curve). An
.mp4 needs ffmpeg, the Debian package of that name; a .gif does not.

Example:
  swirl simulate --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --collisions 12 -o orbit.h5
  swirl animate orbit.h5 -o orbit.gif --duration 2 --fps 10)";

void AnimateOptions::add_to(Flags& command) {
    files.add_to(command, film);
    command.add_option("--frame", frame, "NAME", "container (default), laboratory or co-rotating")
        ->offer({"container", "laboratory", "co-rotating"});
    command
        .add_option("--units", units, "NAME",
                    "of axes and clock: dimensionless (default), or physical: m, s, of a scene in SI units")
        ->offer({"dimensionless", "physical"});
    command.add_option("--fps", fps, "N", "pictures a second (default 20)");
    command.add_option("--duration", duration, "SECONDS", "of the film, in seconds (default 8)");
    command.add_option(
        "--from", from, "T",
        "time of the orbit at which the film begins, in 1/omega_s (--units physical: s; default its first)");
    command.add_option("--to", to, "T",
                       "time at which it ends, in the same unit (default 40/omega_s later, or its last)");
    command.add_option("--orbit", orbit, "I", "which of the record's cycles, from 1 (default 1)");
}

int animate(AnimateOptions& options) {
    std::vector<std::string> own;
    scripts::add_argument(own, "frame", options.frame);
    scripts::add_argument(own, "fps", options.fps);
    scripts::add_argument(own, "duration", options.duration);
    scripts::add_argument(own, "from", options.from);
    scripts::add_argument(own, "to", options.to);
    scripts::add_argument(own, "orbit", options.orbit);
    scripts::add_argument(own, "units", options.units);
    return scripts::run_script(film, options.files, own);
}

}  // namespace swirl::apps::animate
