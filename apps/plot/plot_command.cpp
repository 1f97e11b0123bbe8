#include "apps/plot/plot_command.hpp"

#include <string>
#include <vector>

namespace swirl::apps::plot {

namespace {

const scripts::ScriptOutput figure{
    "plot_record.py", "figure", "swirl plot", {".png", ".svg", ".pdf"}, "drawn by swirl plot"};
const scripts::ScriptOutput words_of_it{
    "plot_record.py", "caption", "swirl plot", {".txt", ".md"}, "drawn by swirl plot"};

}  // namespace

const char* const plot_details =
    R"(Draws a figure of a record. What it can show follows from what the record holds; the first kind is the default:
  simulate            orbit (the next two in one); spin (S(t) with its running time mean); path (of the
                      centre, in the laboratory, in the container and co-rotating with the swirl; with
                      simulate --sample on the wall, too); section (two coordinates just after each impact,
                      --x and --y, coloured by time, or by record where there are several); balance (J, and
                      what restitution and friction change of it at each impact); energy
                      (E_p = m v^2/2 + I omega_p^2/2 over time); contacts (motion on the wall and its
                      events; with --sample normal force, friction and slip)
  classify            verdict (the orbit on the section, S and its spectrum); with --runs shares
  recurrence          recurrence (the plot of --image, the measures and the lengths of lines, or the measures
                      over several thresholds)
  spectrum            spectrum (with its peaks)
  lyapunov            lyapunov (the exponents and their convergence)
  fit                 fit (profiles of e and mu, and what single impacts ask for against their speeds); of a
                      film arcs (frames and the arcs through them, S beside that of the scene found), of
                      falls arcs (height and angle, measured and fitted, with the impacts)
  orbits              multipliers (in the complex plane, with the mean spin of each orbit)
  bifurcate/continue  bifurcation (samples, branches and their special points; where points of one kind lie
                      on one another, the first is drawn, and the legend counts them)
  ramp                ramp (S over the parameter, up and down, where modes were left, and the branches of
                      --branches; over the diagram of bifurcate, if its record is given first)
  boundaries          boundaries (curves in two parameters and their special points; over the mode map of a
                      sweep, if its record is given first)
  certify --plane     cells (proven cells by the number of attracting fixed points; what is not proven is black)
  certify --chaos     sets (where they are, and how the map carries them over one of them)
  sweep, join         modes (bands, a map or panels, by the number of parameters; points of --sample); basins
                      (over two numbers of the start: the attractor that each start came to); attractors
                      (with --track, over one parameter: share and mean S of each); means (mean S or another
                      quantity, --of, over one parameter, --over, a line for each value of another); map
                      (that quantity over two parameters)
  tradeoff            tradeoff (work against precision, how the verdict settles, what pieces of the model add)
  describe            steady-modes
  tour                tour
Several records are drawn below one another, (a), (b), ...; section portraits share their axes. Figures narrower than 127 mm
have their panels below one another. Names of columns' widths are aps, aps-2, nature, nature-2, elsevier and elsevier-2.

--caption FILE says what the figure shows in words: its title, all special points (also those that are not drawn, as they
would lie on one another), and the records.

The Python package swirl_figures draws; notebooks can use it as well. The environment's SWIRL_FIGURES names another folder
that has plot_record.py, SWIRL_PYTHON another interpreter than /usr/bin/python3.

Example:
  swirl simulate --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --collisions 200 -o orbit.h5
  swirl plot orbit.h5 -o orbit.png
  swirl plot orbit.h5 -o section.pdf --kind section --x psi --y vt --width aps --no-title --caption section.txt)";

void PlotOptions::add_to(Flags& command) {
    files.add_to(command, figure, true);
    command.add_option("--kind", kind, "NAME", "which figure, where there are several")
        ->offer({"orbit",  "spin",       "path",     "section",  "balance",      "contacts",    "verdict",
                 "shares", "recurrence", "spectrum", "lyapunov", "multipliers",  "bifurcation", "boundaries",
                 "basins", "attractors", "modes",    "tradeoff", "steady-modes", "tour",        "energy",
                 "means",  "map",        "fit",      "arcs",     "cells",        "ramp",        "sets"});
    command.add_option("--width", width, "WIDTH", "of the figure: millimetres, 3.4in, or a journal's column by name")
        ->offer({"aps", "aps-2", "nature", "nature-2", "elsevier", "elsevier-2"});
    command.add_option("--font-size", font_size, "POINTS", "of the letters, in points (default 9, in a column 8)");
    command.add_flag("--no-title", no_title, "no title above: a paper's caption says it");
    command.add_option("--caption", caption, "FILE",
                       "what the figure shows in words, with every special point: .txt, .md");
    command.add_option("--xlim", xlim, "A:B", "range of the abscissa");
    command.add_option("--ylim", ylim, "A:B", "range of the ordinate");
    command.add_option("--log", log, "AXES", "logarithmic axes: x, y or xy")->offer({"x", "y", "xy"});
    command.add_option("--of", of, "NAME", "of kinds means and map: S (default), exponent, period or RC")
        ->offer({"S", "exponent", "period", "RC"});
    command.add_option("--over", over, "NAME",
                       "of kind means: the parameter along the abscissa (default: that of most values)");
    command
        .add_option("--units", units, "NAME",
                    "of the axes: dimensionless (default), or physical: m, s, kg, of a scene in SI units")
        ->offer({"dimensionless", "physical"});
    command.add_option("--x", x, "NAME", "of kind section: psi (default), chi, vn, vt or S")
        ->offer({"psi", "chi", "vn", "vt", "S"});
    command.add_option("--y", y, "NAME", "of kind section: S (default), or another of these")
        ->offer({"psi", "chi", "vn", "vt", "S"});
}

int plot(PlotOptions& options) {
    std::vector<std::string> own;
    scripts::add_argument(own, "kind", options.kind);
    scripts::add_argument(own, "width", options.width);
    scripts::add_argument(own, "font-size", options.font_size);
    scripts::add_argument(own, "xlim", options.xlim);
    scripts::add_argument(own, "ylim", options.ylim);
    scripts::add_argument(own, "log", options.log);
    scripts::add_argument(own, "of", options.of);
    scripts::add_argument(own, "over", options.over);
    scripts::add_argument(own, "units", options.units);
    scripts::add_argument(own, "x", options.x);
    scripts::add_argument(own, "y", options.y);
    if (options.no_title) own.emplace_back("--no-title");
    if (!options.caption.empty()) {
        scripts::ScriptFiles words = options.files;
        words.output = options.caption;
        scripts::check_output(words_of_it, words);
        scripts::add_argument(own, "caption", options.caption);
    }
    return scripts::run_script(figure, options.files, own);
}

}  // namespace swirl::apps::plot
