// CLI11's two types that options name, without CLI11: its headers alone take some eight seconds of each file's compile
// time, and only what adds flags needs them.
#pragma once

namespace CLI {

class App;
class Option;

}  // namespace CLI
