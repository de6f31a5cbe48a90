# evbal_page_part(VARIABLE FILE...): the text of the files, one after the other; CMake looks at them again when one changes.
function(evbal_page_part variable)
  set(joined "")
  foreach(file IN LISTS ARGN)
    get_filename_component(path ${file} ABSOLUTE)  # the same for all that name the file
    file(READ ${path} text)
    string(APPEND joined "${text}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${path})
  endforeach()
  set(${variable} "${joined}" PARENT_SCOPE)
endfunction()
