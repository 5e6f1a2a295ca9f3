// expect rmse 1e-5: rounding to 16 bits is 4.4e-6; a thousand times as large, so that POV-Ray sees all hits (none nearer than 1e-4)
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 3 adc_bailout 1e-4 }
camera { location <300, 1600, -5000> look_at <0, 600, 0> right x*image_width/image_height angle 40 }
light_source { <4, 6, -5> rgb 0.8  scale 1000 }
background { rgb <0.3, 0.4, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.7, 0.6> rgb <0.2, 0.3, 0.4> scale 0.5 } finish { ambient 0.1 diffuse 0.6 }  scale 1000 }
box { <-1.4, 0.1, 0>, <-0.3, 1.1, 0.2> pigment { rgbt <1, 1, 1, 0.8> } finish { ambient 0.1 diffuse 0.2 reflection 0.2 } interior { ior 1 }  scale 1000 }
box { <-0.4, 0.1, 0.3>, <0.7, 1.1, 0.5> pigment { rgbt <1, 1, 1, 0.8> } finish { ambient 0.1 diffuse 0.2 reflection 0.2 } interior { ior 1.5 }  scale 1000 }
box { <0.6, 0.1, 0.6>, <1.7, 1.1, 0.8> pigment { rgbt <1, 1, 1, 0.8> } finish { ambient 0.1 diffuse 0.2 reflection 0.2 } interior { ior 1 }  scale 1000 }
