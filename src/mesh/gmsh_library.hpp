#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

// The few functions of Gmsh's C API (gmshc.h of Gmsh 4) that read a mesh or make one of a plane area. They
// are the same in versions 4.8 to 4.15. The library is loaded at its first use, since it brings some 90
// others; gxrod is built without it.
namespace gxrod {

// Pointers to the functions. Their last argument takes an error, 0 if there is none. The caller frees arrays
// with `release`.
struct GmshLibrary {
    // The fourth argument is 0. Gmsh 4.8 takes it as a null pointer for the error; later versions, which have
    // a flag before the error, as the flag's 0.
    void (*initialize)(int argc, char** argv, int read_configuration, std::intptr_t zero, int* error);
    void (*finalize)(int* error);
    void (*open)(const char* file, int* error);
    void (*set_number)(const char* option, double value, int* error);
    void (*generate)(int dimension, int* error);
    void (*release)(void* array);
    void (*start_log)(int* error);
    void (*stop_log)(int* error);
    void (*get_log)(char*** lines, std::size_t* count, int* error);
    void (*get_groups)(int** dimensions_and_numbers, std::size_t* count, int dimension, int* error);
    void (*get_group_name)(int dimension, int number, char** name, int* error);
    void (*get_group_entities)(int dimension, int number, int** entities, std::size_t* count, int* error);
    void (*get_group_nodes)(int dimension,
                            int number,
                            std::size_t** nodes,
                            std::size_t* count,
                            double** coordinates,
                            std::size_t* coordinate_count,
                            int* error);
    // Gets the nodes of an entity, or, with −1 and −1, all nodes.
    void (*get_nodes)(std::size_t** nodes,
                      std::size_t* count,
                      double** coordinates,
                      std::size_t* coordinate_count,
                      double** parameters,
                      std::size_t* parameter_count,
                      int dimension,
                      int entity,
                      int include_boundary,
                      int with_parameters,
                      int* error);
    // Gets the numbers and nodes of elements by type.
    void (*get_elements)(int** types,
                         std::size_t* type_count,
                         std::size_t*** elements,
                         std::size_t** element_counts,
                         std::size_t* element_array_count,
                         std::size_t*** nodes,
                         std::size_t** node_counts,
                         std::size_t* node_array_count,
                         int dimension,
                         int entity,
                         int* error);
    // Gets the numbers of views, which are data on a mesh, in the order of their indices.
    void (*get_views)(int** views, std::size_t* count, int* error);
    // Gets the data of a view at a step: of what, elements or nodes, and the values of each.
    void (*get_view_data)(int view,
                          int step,
                          char** of_what,
                          std::size_t** numbers,
                          std::size_t* count,
                          double*** values,
                          std::size_t** value_counts,
                          std::size_t* value_array_count,
                          double* time,
                          int* components,
                          int* error);
    void (*get_text)(const char* option, char** value, int* error);
    // The geometry of Gmsh's own kernel; −1 for numbers that Gmsh chooses. They return the number.
    void (*add_model)(const char* name, int* error);
    int (*add_point)(double x, double y, double z, double size, int number, int* error);
    int (*add_line)(int start, int end, int number, int* error);
    int (*add_curve_loop)(const int* curves, std::size_t count, int number, int reorient, int* error);
    int (*add_plane_surface)(const int* loops, std::size_t count, int number, int* error);
    void (*synchronize)(int* error);
    void (*set_curve_nodes)(int curve, int nodes, const char* spacing, double coefficient, int* error);
};

// Loads the first library found. Throws MeshError, saying what to install, if none is found.
GmshLibrary load_gmsh(std::span<const char* const> names);

// Returns the library under its names in Debian and from Gmsh itself; loaded once.
const GmshLibrary& gmsh_library();

}  // namespace gxrod
