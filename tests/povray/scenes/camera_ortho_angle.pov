// expect rmse 1e-5: rounding to 16 bits is 4.4e-6
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 20 adc_bailout 1e-4 }
camera { orthographic location <2, 2.5, -6> look_at <0, 0.5, 0> angle 25 right x*image_width/image_height }
light_source{<4,6,-5> rgb 0.6}
background { rgb <0.3, 0.4, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.7, 0.6> rgb <0.2, 0.3, 0.4> scale 0.5 } finish { ambient 0.1 diffuse 0.6 } }
sphere { <-0.9, 0.5, 0>, 0.5 pigment { rgb <0.8, 0.3, 0.2> } }
box { <0.2, 0, -0.4>, <1, 0.9, 0.4> pigment { rgb <0.3, 0.6, 0.3> } }
