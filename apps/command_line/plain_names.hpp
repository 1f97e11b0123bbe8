// The commands call what the studies compute by its plain name.
#pragma once

namespace swirl::studies {}

namespace swirl::apps {

using namespace swirl::studies;

}  // namespace swirl::apps
