// The same glass as POV-Ray's users model it: between water and glass stands a gap of width Gap (#declared outside).
#version 3.7;
#include "studio.inc"
#ifdef (Meniscus)
    // No CSG: the film of air is what the hollow leaves of the water.
    cylinder { <0, 0, 0>, <0, 1.6, 0>, 0.8 material { ior 1.5 priority 1 } }
    cylinder { <0, 0.15, 0>, <0, 2, 0>, 0.7 material { ior 1 priority 2 } }
    cylinder { <0, 0.15 + Gap, 0>, <0, 1.2, 0>, 0.7 - Gap material { ior 1.33 priority 3 } }
    sphere { <-0.3, 0.6, -0.2>, 0.16 material { ior 1 priority 4 } }
    sphere { <0.25, 0.9, 0.1>, 0.1 material { ior 1 priority 4 } }
#else
    #declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection { 1 fresnel } conserve_energy } }
    difference {
        cylinder { <0, 0, 0>, <0, 1.6, 0>, 0.8 }
        cylinder { <0, 0.15, 0>, <0, 2, 0>, 0.7 }
        texture { Clear } interior { ior 1.5 }
    }
    difference {
        cylinder { <0, 0.15 + Gap, 0>, <0, 1.2, 0>, 0.7 - Gap }
        sphere { <-0.3, 0.6, -0.2>, 0.16 }
        sphere { <0.25, 0.9, 0.1>, 0.1 }
        texture { Clear } interior { ior 1.33 }
    }
#end
