#include "tests/references/reference_file.hpp"

namespace swirl::tests {

std::string reference_path(const std::string& name) {
    return std::string(SWIRL_REFERENCES) + "/" + name;
}

}  // namespace swirl::tests
