// A dumb-bell of one piece, by CSG.
#version 3.7;
#include "table.inc"
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel } conserve_energy } }
merge {
    sphere { <-0.8, 0.8, 0>, 0.5 }
    sphere { <0.8, 0.8, 0>, 0.5 }
    cylinder { <-0.8, 0.8, 0>, <0.8, 0.8, 0>, 0.25 }
    texture { Clear } interior { ior 1.5 }
}
