// expect rmse 1e-5: rounding to 16 bits is 4.4e-6
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 20 adc_bailout 1e-4 }
camera { location <0.3, 1.6, -5> look_at <0, 0.6, 0> right x*image_width/image_height angle 40 }
light_source { <4, 6, -5> rgb 0.8 }
background { rgb <0.3, 0.4, 0.6> }
plane { y, 0 pigment { checker rgb <0.8, 0.7, 0.6> rgb <0.2, 0.3, 0.4> scale 0.5 } finish { ambient 0.1 diffuse 0.6 } }
#declare T = texture { pigment { checker rgb <0.9, 0.6, 0.2> rgb <0.2, 0.3, 0.6> scale 0.2 } finish { specular 0.4 } }
union { sphere { <-1, 0.5, 0>, 0.4 } box { <-0.4, 0.1, -0.3>, <0.3, 0.9, 0.3> texture { T rotate 30*y } } cylinder { <0.8, 0, 0>, <0.8, 1, 0>, 0.3 pigment { rgb <0.4, 0.7, 0.3> } } texture { T } rotate 15*y scale <1, 1.2, 1> translate <0.1, 0.05, 0> }
