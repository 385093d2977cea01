Merge "surface.surface.msh";
Surface Loop(1) = {1};
Surface Loop(2) = {2};
Surface Loop(3) = {3};
Surface Loop(4) = {4};
Volume(1) = {1};
Volume(2) = {2, 3};
Volume(4) = {4};
