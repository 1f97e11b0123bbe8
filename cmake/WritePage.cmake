# cmake -DFOLDER=apps/explore/page -DOUTPUT=page.cpp -P WritePage.cmake: the page of `swirl explore` as two texts, before
# and after its data. Style, scripts and the map stand in files of their own.
file(READ ${FOLDER}/page.html page)
file(READ ${FOLDER}/page.css style)
file(READ ${FOLDER}/swirl_map.wasm.base64 map)
set(script "")
foreach(part map evidence record draw figure live page)
  file(READ ${FOLDER}/${part}.js text)
  string(APPEND script "${text}")
endforeach()
string(REPLACE "@STYLE@" "${style}" page "${page}")
string(REPLACE "@MAP@" "${map}" page "${page}")
string(REPLACE "@SCRIPT@" "${script}" page "${page}")
string(FIND "${page}" "@DATA@" place)
math(EXPR after "${place} + 6")
string(SUBSTRING "${page}" 0 ${place} head)
string(SUBSTRING "${page}" ${after} -1 rest)
file(WRITE ${OUTPUT} "#include \"apps/explore/page_text.hpp\"

namespace swirl::apps::explore {

std::string_view page_before_data() {
    return R\"swirl_page(${head})swirl_page\";
}

std::string_view page_after_data() {
    return R\"swirl_page(${rest})swirl_page\";
}

}  // namespace swirl::apps::explore
")
