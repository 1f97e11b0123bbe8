#include "apps/notebook/notebook_command.hpp"

namespace swirl::apps::notebook {

namespace {

const scripts::ScriptOutput document{"notebook_of_record.py",  "notebook", "swirl notebook", {".ipynb"},
                                     "made by swirl notebook", 600};

}  // namespace

const char* const notebook_details =
    R"(Writes a Jupyter notebook that shows what the record holds, its numbers and its figure, and executes it. Its cells need
h5py, xarray and matplotlib, and neither swirl nor its packages: whoever gets it can run it again and go on from there. A
record of up to 100 kB is inside the notebook. A larger one is read from its path, or from the notebook's folder where both
have moved there, and is checked by its SHA-256. Making a notebook needs the Debian packages python3-nbformat,
python3-nbclient and python3-ipykernel.

Example:
  swirl simulate --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --collisions 200 -o orbit.h5
  swirl notebook orbit.h5 -o orbit.ipynb)";

void NotebookOptions::add_to(Flags& command) {
    files.add_to(command, document);
}

int notebook(NotebookOptions& options) {
    return scripts::run_script(document, options.files, {});
}

}  // namespace swirl::apps::notebook
