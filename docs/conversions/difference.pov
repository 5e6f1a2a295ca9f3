// A ball with a hollow, by CSG.
#version 3.7;
#include "table.inc"
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel } conserve_energy } }
difference {
    sphere { <0, 0.95, 0>, 0.85 }
    sphere { <0, 1.2, -0.2>, 0.45 }
    texture { Clear } interior { ior 1.5 }
}
