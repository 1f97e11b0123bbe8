# The documents, the manual and the headers as a static site: `cmake --build build/release --target site`. Nothing else needs
# what makes it (docs/site/packages.txt).
find_program(SWIRL_CMARK cmark-gfm)
find_program(SWIRL_DOXYGEN doxygen)
find_program(SWIRL_NODE node)
# The folder is that of docs/site/formulas.py.
find_file(SWIRL_KATEX katex.js PATHS /usr/share/javascript/katex NO_DEFAULT_PATH)
set(swirl_site ${PROJECT_BINARY_DIR}/site)
if(SWIRL_CMARK AND SWIRL_DOXYGEN AND SWIRL_NODE AND SWIRL_KATEX)
  add_custom_target(site
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${PROJECT_BINARY_DIR}/site-pages
    COMMAND swirl manual --format markdown -o ${PROJECT_BINARY_DIR}/site-pages
    COMMAND ${SWIRL_PYTHON} -B ${PROJECT_SOURCE_DIR}/docs/site/gallery.py $<TARGET_FILE:swirl> ${PROJECT_BINARY_DIR}/site-gallery
    COMMAND ${SWIRL_PYTHON} -B ${PROJECT_SOURCE_DIR}/docs/site/build_site.py ${PROJECT_SOURCE_DIR}
      ${PROJECT_BINARY_DIR}/site-pages ${swirl_site} --doxygen ${SWIRL_DOXYGEN}
      --gallery ${PROJECT_BINARY_DIR}/site-gallery
    DEPENDS swirl VERBATIM COMMENT "The site")
else()
  add_custom_target(site
    COMMAND ${CMAKE_COMMAND} -E echo "The site needs cmark-gfm, doxygen, nodejs and libjs-katex: ./quickstart --packages docs/site/packages.txt, then configure again"
    COMMAND ${CMAKE_COMMAND} -E false VERBATIM)
endif()
