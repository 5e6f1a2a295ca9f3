// A lens where two balls overlap, by CSG.
#version 3.7;
#include "table.inc"
#declare Clear = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel } conserve_energy } }
intersection {
    sphere { <0, 0.9, 1.2>, 1.5 }
    sphere { <0, 0.9, -1.2>, 1.5 }
    texture { Clear } interior { ior 1.52 }
}
