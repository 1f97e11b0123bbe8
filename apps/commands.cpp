#include "apps/commands.hpp"

#include "apps/animate/animate_command.hpp"
#include "apps/bifurcate/bifurcate_command.hpp"
#include "apps/boundaries/boundaries_command.hpp"
#include "apps/certify/certify_command.hpp"
#include "apps/classify/classify_command.hpp"
#include "apps/completion/completion_command.hpp"
#include "apps/continue/continue_command.hpp"
#include "apps/describe/describe_command.hpp"
#include "apps/explore/explore_command.hpp"
#include "apps/fit/fit_command.hpp"
#include "apps/inspect/inspect_command.hpp"
#include "apps/lyapunov/lyapunov_command.hpp"
#include "apps/manual/manual_command.hpp"
#include "apps/notebook/notebook_command.hpp"
#include "apps/orbits/orbits_command.hpp"
#include "apps/plot/plot_command.hpp"
#include "apps/ramp/ramp_command.hpp"
#include "apps/recurrence/recurrence_command.hpp"
#include "apps/show/show_command.hpp"
#include "apps/simulate/simulate.hpp"
#include "apps/spectrum/spectrum_command.hpp"
#include "apps/sweep/sweep_command.hpp"
#include "apps/tour/tour.hpp"
#include "apps/tradeoff/tradeoff_command.hpp"

#include <fmt/format.h>

#include <string>

namespace swirl::apps {

void add_commands(Program& program) {
    const std::string classify_text =
        fmt::format("{}\n\n{}", classify::classify_series_details, classify::classify_details);
    const std::string recurrence_text = fmt::format("{}\n{}", input_details, recurrence::recurrence_details);
    const std::string spectrum_text = fmt::format("{}\n{}", input_details, spectrum::spectrum_details);
    program.add_command("simulate", "follow one orbit, impact by impact", simulate::simulate_details,
                        simulate::simulate);
    program.add_command("classify", "name the mode of a scene, with its evidence", classify_text,
                        classify::classify_scene);
    program.add_command("inspect", "what a measured file is taken for", inspect::inspect_details, inspect::inspect);
    program.add_command("recurrence", "quantify the recurrences of an orbit or a measured series", recurrence_text,
                        recurrence::quantify_recurrence);
    program.add_command("spectrum", "the power spectrum of an orbit or a measured series", spectrum_text,
                        spectrum::find_spectrum);
    program.add_command("lyapunov", "the whole Lyapunov spectrum of an orbit", lyapunov::lyapunov_details,
                        lyapunov::lyapunov);
    program.add_command("orbits", "fixed points and cycles, stable and unstable", orbits::orbits_details,
                        orbits::orbits);
    program.add_command("continue", "branches of a cycle over one parameter", continuation::continue_details,
                        continuation::continue_orbit);
    program.add_command("bifurcate", "what orbits settle on over one parameter, and the branches beneath",
                        bifurcate::bifurcate_details, bifurcate::bifurcate);
    program.add_command("ramp", "one orbit while a parameter changes slowly, up and down", ramp::ramp_details,
                        ramp::ramp);
    program.add_command("boundaries", "curves in two parameters on which cycles bifurcate",
                        boundaries::boundaries_details, boundaries::boundaries);
    program.add_command("sweep", "the modes across parameters", sweep::sweep_details, sweep::sweep);
    program.add_command("tradeoff", "accuracy against cost, measured on a scene", tradeoff::tradeoff_details,
                        tradeoff::tradeoff);
    program.add_command("join", "one record of the shards of a sweep", sweep::join_details, sweep::join);
    program.add_command("describe", "what is known of a scene in closed form", describe::describe_details,
                        describe::describe);
    program.add_command("certify", "prove cycles by interval arithmetic", certify::certify_details, certify::certify);
    program.add_command("fit", "restitution, friction and the law of impact from measurements", fit::fit_details,
                        fit::fit);
    program.add_command("show", "what a record holds, as a table, JSON or CSV", show::show_details, show::show);
    program.add_command("plot", "a figure of a record", plot::plot_details, plot::plot);
    program.add_command("animate", "a film of an orbit", animate::animate_details, animate::animate);
    program.add_command("explore", "a page of a record, in which the map runs", explore::explore_details,
                        explore::explore);
    program.add_command("notebook", "a notebook of a record, executed", notebook::notebook_details, notebook::notebook);
    program.add_command("tour", "name the modes of a built-in set of scenes", tour::tour_details, tour::tour);
    program.add_command("manual", "a page of the manual", manual::manual_details, manual::manual);
    program.add_command("completion", "the script by which a shell completes words", completion::completion_details,
                        completion::completion);
}

}  // namespace swirl::apps
