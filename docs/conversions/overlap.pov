// Water that reaches 0.05 into the wall: who is there depends on where a ray comes from.
#version 3.7;
#include "table.inc"
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel } conserve_energy } }
difference {
    cylinder { <0, 0.1, 0>, <0, 1.8, 0>, 0.8 }
    cylinder { <0, 0.25, 0>, <0, 1.9, 0>, 0.7 }
    texture { Clear } interior { ior 1.5 }
}
cylinder { <0, 0.2, 0>, <0, 1.4, 0>, 0.75 texture { Clear } interior { ior 1.33 } }
