// A ball of glass between a lamp and the wall: Meniscus has no photons, and light through clear glass goes straight on.
// pixel 40, 30
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 60 adc_bailout 1e-9 photons { spacing 0.003 } }
camera { location <0, 2, -1> look_at 0 right 4/3*x angle 30 }
light_source { -1000*z, rgb 0.2 photons { refraction on } }
plane { -z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
sphere {
    -3*z, 0.9
    pigment { rgbt 1 } finish { ambient 0 diffuse 0 }
    interior { ior 1.3 }
    photons { target refraction on collect off }
}
