/*! cotouch page; sources b4d0301272598101d28169be9d062a3565a10ebb5a9908c90ff5dafbb470b81c; licences of what it contains: licences.txt */
var gu=["#0072B2","#D55E00","#009E73","#CC79A7","#E69F00","#56B4E9","#8B6F47","#6B7280"],Gv=["#3D9FE0","#F08438","#2BC495","#DE97BF","#F2B73C","#86CCF5","#B3946A","#9CA3AF"];var Hv=["#414487","#355F8D","#2A788E","#21908D","#22A884","#43BF71","#7AD151","#BBDF27","#FDE725"],il=Hv,nl=typeof matchMedia=="function"?matchMedia("(prefers-color-scheme: dark)"):null;function Vs(i){return i==="dark"||i==="auto"&&nl!==null&&nl.matches}function qr(i){return nl?.addEventListener("change",i),()=>nl?.removeEventListener("change",i)}function _i(i,e){return(e?Gv:gu)[i%gu.length]}function _p(i,e=document.documentElement){let t=Vs(i);e.dataset.theme=t?"dark":"light",e.style.colorScheme=t?"dark":"light";for(let n=0;n<gu.length;n++)e.style.setProperty(`--user-${n}`,_i(n,t))}function Gs(i){let e=parseInt(i.slice(1),16);return[e>>16,e>>8&255,e&255]}function Hs(i,e){return`rgb(${Gs(i).join(" ")} / ${e})`}var bp=["script","free","hold","pull","wander","grab","ball"];var Wv=["ball","grab","free"],Sp=2,yu=32,Mp=68;function ia(i){let e=atob(i),t=new Uint8Array(e.length);for(let n=0;n<e.length;n++)t[n]=e.charCodeAt(n);return t.buffer}function wp(i){let e=new Float32Array(ia(i.nodes.rest)),t=i.skin&&{vertices:i.skin.vertices,rest:new Float32Array(ia(i.skin.rest)),triangles:new Uint32Array(ia(i.skin.triangles)),node:new Uint32Array(ia(i.skin.node))};return{...i,nodes:{count:i.nodes.count,rest:e},skin:t,edges:i.edges?new Uint32Array(ia(i.edges)):null,started:String(i.started),points:t?t.rest:e}}function vu(i,e){return[i.getFloat32(e,!0),i.getFloat32(e+4,!0),i.getFloat32(e+8,!0)]}function Ep(i,e){let t=new DataView(i);if(i.byteLength<yu||t.getUint8(0)!==1||t.getUint8(1)!==Sp)throw new RangeError("not a frame of version 1");let n=t.getUint16(2,!0),s=t.getUint32(16,!0),r=Mp+4*Math.ceil(s*6/4);if(i.byteLength!==yu+n*r)throw new RangeError("a frame of the wrong length");let o=[];for(let a=0;a<n;a++){let l=yu+a*r,c=t.getUint8(l+2);o.push({slot:t.getUint8(l),mode:bp[t.getUint8(l+1)]??"free",direct:(c&1)>0,hasHand:(c&2)>0,hands:t.getUint8(l+3),age:t.getFloat32(l+4,!0),target:vu(t,l+8),place:vu(t,l+20),force:vu(t,l+32),radius:t.getFloat32(l+44,!0),energy:t.getFloat32(l+48,!0),supplied:t.getFloat32(l+52,!0),lost:t.getFloat32(l+56,!0),linked:t.getFloat32(l+60,!0),node:t.getInt32(l+64,!0),displacement:new Int16Array(i,l+Mp,s*3)})}return{number:t.getUint32(4,!0),time:t.getFloat64(8,!0),points:s,scale:t.getFloat32(20,!0),echo:t.getUint32(24,!0),served:t.getUint32(28,!0)/1e6,copies:o,received:e}}function Tp(i){let e=new DataView(new ArrayBuffer(40));return e.setUint8(0,2),e.setUint8(1,i.slot),e.setUint8(2,Wv.indexOf(i.action)),e.setUint32(4,i.number,!0),e.setUint32(8,i.point,!0),i.target.forEach((t,n)=>e.setFloat32(12+4*n,t,!0)),e.setFloat32(24,i.radius,!0),e.setFloat32(28,i.stiffness,!0),e.setFloat64(32,i.time,!0),e.buffer}function Ap(i,e,t){let n=new DataView(new ArrayBuffer(16));return n.setUint8(0,3),n.setUint32(4,i,!0),n.setFloat32(8,e,!0),n.setFloat32(12,t,!0),n.buffer}function Cp(i,e,t){return JSON.stringify({type:"hello",version:Sp,token:i,slot:e,want:"all",rate:t})}var sl=class{gaps=[];last=0;every=0;lead=4;get ahead(){return this.lead}picture(e){let t=e-this.last;t<=0||(this.last=e,!(t>60)&&(this.gaps.push(t),this.gaps.length>24&&this.gaps.shift(),this.gaps.length===24&&(this.every=[...this.gaps].sort((n,s)=>n-s)[6])))}came(e){if(!this.every||e-this.last>240)return[0,0];let t=this.until(e);return t<.5||t>this.lead+Math.min(3.5,.35*this.every)?this.lead+=.6:this.lead-=.04,this.lead>this.every+.5&&(this.lead-=this.every),this.lead<.5&&(this.lead=.5),[this.until(e+this.lead),this.every]}until(e){let t=(e-this.last)%this.every;return t<0?-t:this.every-t}};var xu=250,Rp=2e3,Xv=1e4,_u=500,qv=3e3,$v=8e3,Yv=5e3,Jv=8,Zv=60,Kv=300,jv=5;function Qv(i,e){return i.action===e.action&&i.point===e.point&&i.radius===e.radius&&i.stiffness===e.stiffness&&i.target.every((t,n)=>t===e.target[n])}var rl=class{constructor(e,t,n){this.store=e;this.token=t;this.address=n;e.on("slot",()=>this.hello()),document.addEventListener("visibilitychange",()=>{this.heard=performance.now(),this.hello()}),addEventListener("online",()=>this.hurry()),this.looking=window.setInterval(()=>this.look(),_u),this.dial()}store;token;address;onPoint=null;screen=new sl;socket=null;wait=xu;timer=0;asked=0;answers=new Map;number=0;pending=null;state=null;told=null;pointed=-1/0;pointTimer=0;closed=!1;greeted=!1;said=null;heard=0;looked=performance.now();looking;get mayAct(){let{live:e,state:t,scene:n,slot:s}=this.store;return e&&this.hasToken&&t?.control!=="other"&&!!n?.own.includes(s)}get hasToken(){return this.token!==null&&this.store.scene?.acts!==!1}get tokenWrong(){return this.token!==null&&!this.hasToken}link(e,t={}){return`${e}?${new URLSearchParams({token:this.token??"",...t})}`}do(e){let t=this.socket;if(!t||t.readyState!==WebSocket.OPEN)return Promise.resolve({ok:!1,text:"There is no connection to the server."});let n=++this.asked;return new Promise(s=>{let r=setTimeout(()=>this.answer(n,{ok:!1,text:"The server did not answer."}),Xv);this.answers.set(n,o=>{clearTimeout(r),s(o)}),t.send(JSON.stringify({...e,type:"do",id:n}))})}point(e){if(this.told&&Qv(this.told,e))return;this.pending?.action==="free"&&e.action!=="free"&&this.flush(),this.told=e,this.pending={...e,time:e.time??performance.now()};let t=this.pointed+Jv-performance.now();t<=0||e.action==="free"?this.flush():this.pointTimer||(this.pointTimer=setTimeout(()=>this.flush(),t))}close(){this.closed=!0,clearInterval(this.looking),clearTimeout(this.timer),clearTimeout(this.pointTimer),this.socket?.close()}flush(){clearTimeout(this.pointTimer),this.pointTimer=0;let e=this.pending;if(this.pending=null,!e||!this.mayAct||this.socket?.readyState!==WebSocket.OPEN)return;this.pointed=performance.now();let t=++this.number,n=e.time;this.socket.send(Tp({...e,slot:this.store.slot,number:t,time:n})),this.onPoint?.(t,n)}dial(){if(clearTimeout(this.timer),this.closed)return;let e=new WebSocket(this.address);e.binaryType="arraybuffer",this.socket=e,this.heard=performance.now();let t="";e.onopen=()=>{this.told=null,this.hello()},e.onmessage=({data:n})=>{if(this.socket!==e)return;if(this.heard=performance.now(),this.store.connection==="silent"&&this.greeted&&this.store.connected("open"),n instanceof ArrayBuffer){let r=Ep(n,performance.now());if(e.send(Ap(r.number,...this.screen.came(r.received))),requestAnimationFrame(o=>this.screen.picture(o)),this.store.state?.ended&&this.store.frame)return;this.store.scene&&r.points*3===this.store.scene.points.length&&this.store.drawn(r);return}let s=JSON.parse(n);s.type==="scene"?(this.wait=xu,this.greeted=!0,this.store.connected("open"),this.state=null,this.store.show(wp(s)),this.said!==this.store.slot&&this.hello()):s.type==="state"?this.tell(s):s.type==="answer"?this.answer(s.id,s):s.type==="error"&&(t=String(s.text))},e.onclose=()=>{this.socket===e&&this.ended(t)}}ended(e,t=!1){this.socket=null,this.greeted=!1;for(let n of[...this.answers.keys()])this.answer(n,{ok:!1,text:"The connection was lost before an answer came."});e?this.store.connected("refused",e):t?this.store.connected("silent"):this.store.connection!=="refused"&&this.store.connected(this.store.scene?"lost":"connecting"),!this.closed&&(this.timer=window.setTimeout(()=>this.dial(),e?Rp:this.wait),this.wait=Math.min(2*this.wait,Rp))}look(){let e=performance.now(),t=e-this.looked>3*_u;this.looked=e,t&&(this.heard=Math.max(this.heard,e-_u));let{socket:n}=this;if(!n||document.hidden)return;let s=e-this.heard;s>(this.greeted?$v:Yv)?(this.socket=null,n.close(),this.ended("",!0)):this.greeted&&s>qv&&this.store.connected("silent")}tell(e){let t=this.state!==null;if(this.state=e,t)return;let n=()=>{clearTimeout(s);let r=this.state;this.state=null,r&&this.store.told(r)},s=setTimeout(n,Kv);this.store.state?requestAnimationFrame(()=>setTimeout(n)):n()}hello(){this.socket?.readyState===WebSocket.OPEN&&(this.said=this.store.scene||this.store.wished!==null?this.store.slot:null,this.socket.send(Cp(this.token,this.said,document.hidden?jv:Zv)))}hurry(){this.socket||(this.wait=xu,this.dial())}answer(e,t){this.answers.get(e)?.(t),this.answers.delete(e)}};var mr=class{constructor(e){this.current=e}current;listeners=new Set;get(){return this.current}set(e){if(!Object.is(e,this.current)){this.current=e;for(let t of[...this.listeners])t(e)}}on(e){return this.listeners.add(e),()=>this.listeners.delete(e)}},Pp=["users","network","plots","energy","margin","events"];function wt(i,e){return i.scene?.users.find(t=>t.slot===e)?.name??`user ${e+1}`}function ji(i,e){return i<e?[i,e]:[e,i]}function Jn(i){return`${i[0]}-${i[1]}`}function Qi(i,e){return i===e||i!==null&&e!==null&&i[0]===e[0]&&i[1]===e[1]}function Et(i,e){let{store:t,connection:n}=i;return t.live&&n.hasToken&&!!t.scene?.may.includes(e)}function Ip(i,e,t){let{scene:n,frame:s}=i.store;if(!n)return null;let r=s?.copies.find(c=>c.slot===e),o=n.nodes.rest,a=r&&r.node>=0&&r.node<n.nodes.count?r.node:-1;if(a<0){let c=-1/0;for(let h=0;h<n.nodes.count;h++){let u=o[3*h]*t[0]+o[3*h+1]*t[1]+o[3*h+2]*t[2];u>c+1e-9&&([c,a]=[u,h])}}if(a<0)return null;let l=n.dimension===1?Math.max(n.radius,.1):.35*n.radius;return{node:a,to:[0,1,2].map(c=>o[3*a+c]+l*t[c])}}var ex="http://www.w3.org/2000/svg";function Lp(i,e,t){for(let[n,s]of Object.entries(e??{}))s==null||s===!1||(n.startsWith("on")&&typeof s=="function"?i.addEventListener(n.slice(2),s):i.setAttribute(n,s===!0?"":String(s)));for(let n of t)n&&i.append(n)}function O(i,e=null,...t){let n=document.createElement(i);return Lp(n,e,t),n}function Jt(i,e=null,...t){let n=document.createElementNS(ex,i);return Lp(n,e,t),n}function Le(i,e){i.textContent!==e&&(i.textContent=e)}function Ge(i,e,t){t===null?i.removeAttribute(e):i.getAttribute(e)!==t&&i.setAttribute(e,t)}function dt(i,e){i.hidden===e&&(i.hidden=!e)}var Np={good:"M8 1.8a6.2 6.2 0 1 0 0 12.4A6.2 6.2 0 0 0 8 1.8M5.2 8.2l2 2 3.7-4.2",warn:"M8 2 1.8 13.2h12.4zM8 6.4v3.2M8 11.3v.3",bad:"M5.4 1.8h5.2l3.6 3.6v5.2l-3.6 3.6H5.4l-3.6-3.6V5.4zM5.8 5.8l4.4 4.4M10.2 5.8l-4.4 4.4",wait:"M8 1.8a6.2 6.2 0 1 0 0 12.4A6.2 6.2 0 0 0 8 1.8M8 4.6V8l2.4 1.6",close:"m4 4 8 8M12 4l-8 8",cut:"M5.6 10.6 12.6 3M10.4 10.6 3.4 3M4.2 10.4a1.7 1.7 0 1 0 0 3.4 1.7 1.7 0 0 0 0-3.4M11.8 10.4a1.7 1.7 0 1 0 0 3.4 1.7 1.7 0 0 0 0-3.4",mend:"M6.6 9.4a2.6 2.6 0 0 0 3.8.2l2-2a2.6 2.6 0 0 0-3.7-3.7l-1 1M9.4 6.6a2.6 2.6 0 0 0-3.8-.2l-2 2a2.6 2.6 0 0 0 3.7 3.7l1-1",invite:"M6.4 2.4a2.6 2.6 0 1 0 0 5.2 2.6 2.6 0 0 0 0-5.2M1.8 13.6c.3-2.6 2-4 4.6-4s4.3 1.4 4.6 4M12.4 5v4M10.4 7h4",tour:"M8 1.8a6.2 6.2 0 1 0 0 12.4A6.2 6.2 0 0 0 8 1.8m2.8 3.4L9.2 9.2l-4 1.6 1.6-4z",light:"M8 5.2a2.8 2.8 0 1 0 0 5.6 2.8 2.8 0 0 0 0-5.6M8 1.4v1.4M8 13.2v1.4M1.4 8h1.4M13.2 8h1.4M3.3 3.3l1 1M11.7 11.7l1 1M12.7 3.3l-1 1M4.3 11.7l-1 1",dark:"M13.4 9.6A5.8 5.8 0 0 1 6.4 2.6a5.8 5.8 0 1 0 7 7z",auto:"M8 1.8a6.2 6.2 0 1 0 0 12.4A6.2 6.2 0 0 0 8 1.8v12.4M8 5h3.6M8 8h5.6M8 11h3.6",record:"M8 4.6a3.4 3.4 0 1 0 0 6.8 3.4 3.4 0 0 0 0-6.8",stop:"M4.8 4.8h6.4v6.4H4.8z",save:"M8 2.4v7M5 6.8l3 3 3-3M2.8 13.2h10.4",pause:"M5.6 3.6v8.8M10.4 3.6v8.8",play:"m5.2 3.4 7 4.6-7 4.6z",keys:"M1.8 4.4h12.4v7.4H1.8zM4.4 7h.2M7 7h.2M9.6 7h.2M12 7h.2M5 9.4h6",reset:"M3 8a5 5 0 1 0 1.6-3.7M3 2.6v2.6h2.6",grab:"M5 8.4V4.6a1 1 0 0 1 2 0V7.4 3.4a1 1 0 0 1 2 0v4-3a1 1 0 0 1 2 0v3.4-1.6a1 1 0 0 1 2 0v3.4c0 3-1.6 4.6-4.2 4.6-2 0-2.8-.8-4-2.6L2.6 8.8c.6-.8 1.6-.8 2.4-.4",ball:"M6.2 6.2a3.6 3.6 0 1 0 0-.1M1.6 13.4c3.4 0 3.4-3.4 6.2-3.4s3 3.4 6.6 3.4",ghosts:"M8 2.2c-2.6 0-4.2 2-4.2 4.4v6.6l1.6-1.2 1.4 1.2L8 12l1.2 1.2 1.4-1.2 1.6 1.2V6.6c0-2.4-1.6-4.4-4.2-4.4M6.4 6.4v.4M9.6 6.4v.4",side:"M2 3.4h5v9.2H2zM9 3.4h5v9.2H9z",overlay:"M2.4 2.4h7.8v7.8H2.4zM5.8 5.8h7.8v7.8H5.8z",minus:"M3.4 8h9.2",tick:"m3.4 8.4 3 3 6.2-6.8"};function vn(i,e=16){return Jt("svg",{viewBox:"0 0 16 16",width:e,height:e,class:`icon icon-${i}`,"aria-hidden":"true"},Jt("path",{d:Np[i]}))}function On(i,e){Ge(i,"class",`icon icon-${e}`);let t=i.firstElementChild;t&&Ge(t,"d",Np[e])}function $e(i,e,t={}){return O("button",{type:"button",class:t.class??"button",id:t.id,"aria-label":t.label,"data-tip":t.tip,onclick:e},t.icon&&vn(t.icon),i&&O("span",null,i))}function gr(i,e,t){let n=new Map,s=O("div",{class:"choice",role:"radiogroup","aria-label":i});for(let o of e){let a=$e(o.words,()=>t(o.value),{class:"choice-one",...o.icon?{icon:o.icon}:{},...o.tip?{tip:o.tip}:{}});a.setAttribute("role","radio"),a.setAttribute("aria-checked","false"),a.dataset.value=o.value,n.set(o.value,a),s.append(a)}s.addEventListener("keydown",o=>{let a={ArrowRight:1,ArrowDown:1,ArrowLeft:-1,ArrowUp:-1}[o.key];if(!a)return;let l=[...n.values()].filter(h=>!h.disabled),c=l.indexOf(document.activeElement);l[(c+a+l.length)%l.length]?.focus(),o.preventDefault(),o.stopPropagation()});let r=()=>{let o=[...n.values()],a=o.find(l=>l.getAttribute("aria-checked")==="true")??o[0];for(let l of o)Ge(l,"tabindex",l===a?"0":"-1")};return r(),{element:s,mark(o){for(let[a,l]of n)Ge(l,"aria-checked",String(a===o));r()},allow(o,a){let l=n.get(o);l&&(l.disabled=!a)},say(o,a,l){let c=n.get(o);c&&(c.lastElementChild&&Le(c.lastElementChild,a),Ge(c,"data-tip",l))}}}var tx=0;function bi(i,e,t,...n){let s=`explained-${++tx}`,r=O("div",{class:"explanation",id:s,hidden:!0},t),o=O("button",{type:"button",class:"ask","aria-expanded":"false","aria-controls":s,"aria-label":`What ${e} shows`},"?");o.addEventListener("click",()=>{r.hidden=!r.hidden,o.setAttribute("aria-expanded",String(!r.hidden))});let a=O("div",{class:"panel-head"},O("h2",{id:`${i}-title`},e),o,O("div",{class:"grow"}),...n),l=O("div",{class:"panel-body"});return{element:O("section",{id:i,class:"panel","aria-labelledby":`${i}-title`},a,r,l),body:l,head:a}}function es(i,e){let t=Math.abs(i).toFixed(e);return i<0&&Number(t)!==0?"−"+t:t}function Zn(i,e=0){return i==null||!Number.isFinite(i)?"–":es(i,e)}var nx=[[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""],[.001,"m"],[1e-6,"µ"],[1e-9,"n"],[1e-12,"p"]];function Ws(i,e,t=0){if(i==null||!Number.isFinite(i))return"–";let n=Math.abs(i);if(n<=t||n<1e-15)return`0 ${e}`;let[s,r]=nx.find(([l])=>n>=l*.9995)??[1e-12,"p"],o=i/s,a=Math.abs(o)>=99.95?0:Math.abs(o)>=9.995?1:2;return`${es(o,a)} ${r}${e}`}function ol(i){return i==null||!Number.isFinite(i)?"–":Math.abs(i)<10?`${es(i,2)} N`:`${es(i,1)} N`}function kn(i){if(i==null||!Number.isFinite(i))return"–";let e=Math.abs(i);return e>=.9995?`${es(i,2)} s`:`${es(i*1e3,e<.00995?1:0)} ms`}function xn(i,e){if(i==null||!Number.isFinite(i))return"–";let t=i*100,n=Math.abs(t);return`${es(t,e??(n===0||n>=9.95?0:1))} %`}function Dp(i){return i==null||!Number.isFinite(i)?"–":Math.abs(i)<.1?`${es(i*1e3,1)} mm`:`${es(i*100,1)} cm`}function al(i){return i==null?"–":`${es(i,0)} Hz`}function ll(i){let e=Math.max(0,Math.floor(i));return`${Math.floor(e/60)}:${String(e%60).padStart(2,"0")}`}function sa(i){return String(Math.round(i)).replace(/\B(?=(\d{3})+$)/g," ")}function ts(i,e){return`${Math.min(i,e)+1}–${Math.max(i,e)+1}`}var ix=8e3;function ns(i,e,t,...n){let s=O("span",null),r=O("div",{class:`banner banner-${i}`,id:e,role:i==="bad"?"alert":"status",hidden:!0},vn(i==="info"?"wait":i,16),s,...n);return{element:r,update:()=>{let o=t();dt(r,o!==null),o!==null&&Le(s,o)}}}function Up(i){let{store:e,connection:t}=i,n=$e("Restore now",()=>{i.act({what:"damping",fraction:1})},{class:"button small primary"}),s=$e("Take over",()=>{i.act({what:"control"})},{class:"button small primary"}),r=$e("Cancel",()=>i.aiming.set(null),{class:"button small"}),o=!1,a=0,l=$e("Dismiss",()=>{clearTimeout(a),a=0,y()},{class:"button small"}),c=()=>{let p=(e.state?.damping??1)<1;o&&!p&&e.live&&(a=window.setTimeout(()=>l.click(),ix)),p&&(a=0),o=p},h=()=>!!e.state?.ended,u="",d=$e("Dismiss",()=>{u=m(),y()},{class:"button small"}),m=()=>{let{state:p}=e;return[...Object.entries(p?.members??{}).filter(([,v])=>v.recording==="failed").map(([v,M])=>`The recording of ${wt(e,Number(v))} stopped${M.recording_failure?`: ${M.recording_failure}`:""}.`),...p?.recording.troubles.length?[`${p.recording.state==="failed"?"Nothing was recorded":"The recording is not whole"}: ${p.recording.troubles.join("; ")}.`]:[]].join(" ")},g=[ns("bad","banner-lost",()=>e.connection==="lost"&&!h()?"The connection is lost; what you see is the last that was known. Connecting again …":null),ns("bad","banner-silent",()=>h()?null:e.connection==="silent"?"No answer from the server. What you see is the last that was known; nothing can be changed until it answers.":e.stalled?"The session’s process does not answer. Users, links and energies are as they were last known; nothing can be changed until it answers.":null),ns("bad","banner-refused",()=>e.connection==="refused"?`The server refused this page: ${e.refusal||"no reason was given."}`:null),ns("info","banner-ended",()=>e.connection!=="refused"&&h()?"The session has ended. What you see is its last moment.":null),ns("bad","banner-recording",()=>{let p=m();return p&&p!==u?p:null},d),ns("bad","banner-damping",()=>{let p=e.state?.damping??1;return n.disabled=!Et(i,"damping"),e.live&&p<1?`Damping is lowered to ${xn(p,p<.01?1:0)} of what is needed: energy can grow by itself.`:null},n),ns("info","banner-restored",()=>a&&e.live?"All damping is back: the copies come to rest.":null,l),ns("info","banner-view",()=>e.connection==="open"&&e.scene&&!t.hasToken?t.tokenWrong?"You are watching: the token in this address is not that of the session that runs now. Open the address that cotouch printed last.":"You are watching. To take part, open the address with the token that cotouch printed.":null),ns("warn","banner-control",()=>e.live&&t.hasToken&&e.state?.control==="other"?`Another page holds the control of ${wt(e,e.slot)}.`:null,s),ns("info","banner-aim",()=>{let p=i.aiming.get();return p?`Click in the picture where ${wt(e,p.slot)} shall pull.`:null},r)],y=()=>{c();for(let f of g)f.update();let p=["silent","lost","refused"].includes(e.connection)||e.stalled;document.documentElement.toggleAttribute("data-lost",p&&!h()),document.documentElement.toggleAttribute("data-ended",h())};for(let p of["scene","state","connection","slot"])e.on(p,y);return i.aiming.on(y),y(),O("div",{class:"banners"},...g.map(p=>p.element))}var sx={auto:"light",light:"dark",dark:"auto"},Fp={auto:"as the system",light:"light",dark:"dark"};function bu(i){i.set({theme:sx[i.settings.theme]})}function Op(i){let e=$e("",()=>bu(i),{icon:"auto",class:"button bare",label:"Theme",id:"theme"}),t=()=>{let{theme:n}=i.settings,s=e.querySelector("svg");s&&On(s,n),e.setAttribute("aria-label",`Theme: ${Fp[n]}`),e.setAttribute("data-tip",`Theme: ${Fp[n]} (D)`)};return i.on("settings",t),t(),e}var rx={good:"good",warn:"take note",bad:"not guaranteed"},ox={connecting:"Connecting …",open:"Waiting for the copies …",silent:"No answer",lost:"Connection lost",refused:"Refused"};function ax(){return Jt("svg",{viewBox:"0 0 24 24",width:24,height:24,class:"mark","aria-hidden":"true"},Jt("circle",{cx:8,cy:9,r:5.4,class:"mark-a"}),Jt("circle",{cx:16,cy:9,r:5.4,class:"mark-b"}),Jt("circle",{cx:12,cy:15.6,r:5.4,class:"mark-c"}))}var lx=1e4;function cx(i){let{store:e,connection:t}=i,n=()=>e.state?.recording.state==="ending",s=()=>{Et(i,"record")&&!n()&&i.act({what:"record",on:e.state?.recording.state!=="on"})},r=O("span",{class:"tabular"},"Record"),o=O("button",{type:"button",class:"button",id:"record","data-tip":"Record what every copy does, to audit or replay it (R)"},vn("record"),r);o.addEventListener("click",s);let a=$e("",()=>{hx(i)},{icon:"save",class:"button",id:"download",label:"Download the recording"});a.append(O("span",{class:"label"},"Download"));let l=-1,c=()=>{let h=e.state?.recording,u=h?.state==="on",d=!!h?.troubles.length&&h.state!=="off";Ge(o,"data-on",u?"":null),Ge(o,"data-wrong",d?"":null),Ge(o,"aria-pressed",String(u));let m=u?"Stop recording":n()?"The recording is being finished":"Record";Ge(o,"aria-label",d?`${m}; the recording is not whole`:m);let g=o.querySelector("svg");g&&On(g,u?d?"warn":"stop":n()?"wait":h?.state==="failed"?"warn":"record"),Le(r,u?ll(h.seconds):n()?"Finishing …":"Record"),o.disabled=!Et(i,"record")||n(),dt(o,!!e.scene?.may.includes("record")),dt(a,h?.state==="done"&&t.hasToken),a.disabled=e.connection!=="open",h?.state==="done"&&Ge(a,"data-tip",`${h.text}, as a ZIP of MCAP files`);let y=h?.state==="done"||h?.state==="failed"?h.number:0;h&&y>l&&l>=0&&i.say(h.state==="done"?`Recorded: ${h.text}.`:"Nothing was recorded.",h.troubles.length?"bad":"good"),h&&(l=y||Math.max(0,h.number-1))};for(let h of["scene","state","connection"])e.on(h,c);return c(),{element:O("div",{class:"recorder"},o,a),toggle:s}}async function hx(i){let e=i.connection.link("recording.zip");try{if(!(await fetch(e,{method:"HEAD",cache:"no-store",signal:AbortSignal.timeout(lx)})).ok)return i.say("The server does not have the recording any more.","bad")}catch{return i.say("The server did not answer; the recording is still there. Try again.","bad")}O("a",{href:e,download:"cotouch-recording.zip"}).click()}function kp(i,e){let{store:t}=i,n=O("span",{class:"session"}),s=vn("wait",18),r=O("span",{class:"unseen"}),o=O("span",{class:"verdict-words"},"Connecting …"),a=O("button",{type:"button",class:"verdict",id:"verdict"},s,r,o);a.addEventListener("click",()=>i.tab.set("margin"));let l=$e("Invite",e.invite,{icon:"invite",class:"button",id:"invite",tip:"Let somebody take part from another computer (I)"}),c=cx(i),h=O("header",{class:"bar"},O("h1",{class:"brand"},ax(),O("span",null,"cotouch"),n),a,O("div",{class:"bar-tools"},c.element,l,$e("Tour",e.tour,{icon:"tour",class:"button",id:"tour-open",tip:"Two minutes through everything (T)"}),$e("",e.keys,{icon:"keys",class:"button bare",label:"Keyboard shortcuts",tip:"Keyboard shortcuts (?)"}),Op(t))),u=()=>{Le(n,t.scene?.title??""),Ge(n,"title",t.scene?`${t.scene.title} · cotouch ${t.scene.version}`:null);let d=t.live||t.state?.ended?t.state?.verdict:void 0;Ge(a,"data-level",d?.level??"none"),On(s,d?.level??"wait"),Le(r,d?`${rx[d.level]}: `:"");let m=d?.text??ox[t.stalled?"silent":t.connection],g=m&&m[0]?.toUpperCase()+m.slice(1);Le(o,g),Ge(a,"data-tip",`${g}. Safe (passive) means: nobody gets out energy that nobody put in. Opens the margin of every link.`);let y=[t.scene?.title,"cotouch"].filter(Boolean).join(" · ");document.title!==y&&(document.title=y),l.hidden=!t.scene?.invitation};for(let d of["scene","state","connection"])t.on(d,u);return u(),{element:h,record:c.toggle}}var ux="Every step books where its energy went, to rounding, so both bars are equally long: what came in is what is still there or was damped. Hands put energy in, and take some back. Links are springs between copies: they give back what they hold, and delay makes them give more than they took, because news that is late pushes at the wrong moment. The damping is made to take at least that; this is what keeps the session stable. As members come and go each copy holds another share of the object, and of its energy. What is left over after all this is rounding.";function dx(i,e,t){let n=o=>(e[o]??0)-(t?.[o]??0),s=t?t.energy??0:e.initial??0,r={slot:i,initial:s,hands:n("supplied"),links:n("linked"),shared:n("rescaled"),damped:n("lost"),stored:e.energy??0};return{...r,residual:r.initial+r.hands+r.links+r.shared-r.damped-r.stored}}function fx(i){let e=[],t=[],n=(s,r,o)=>{s>0?e.push({...r,value:s}):s<0&&t.push({...o,value:-s})};for(let s of i)n(s.hands,{label:"hand",class:"hand",slot:s.slot},{label:"taken back by hand",class:"hand",slot:s.slot});return n(i.reduce((s,r)=>s+r.initial,0),{label:"at the start",class:"initial"},{label:"at the start",class:"initial"}),n(i.reduce((s,r)=>s+r.links,0),{label:"added by links",class:"links"},{label:"held or taken by links",class:"links"}),n(i.reduce((s,r)=>s+r.shared,0),{label:"members went",class:"shared"},{label:"members came",class:"shared"}),n(-i.reduce((s,r)=>s+r.damped,0),{label:"dampers",class:"damped"},{label:"damped",class:"damped"}),n(-i.reduce((s,r)=>s+r.stored,0),{label:"copies",class:"stored"},{label:"in the copies",class:"stored"}),{came:e,went:t}}var $r=[{key:"hands",words:"hands",sign:"",tip:"Put in by this user’s hand, less what it took back"},{key:"links",words:"links",sign:"+",tip:"Work of the links on this copy: what delays added, less what springs hold"},{key:"initial",words:"start",sign:"+",tip:"In the copy when counting began"},{key:"shared",words:"shares",sign:"+",tip:"What this copy gained or lost as members came and went: each then holds another share of the object"},{key:"damped",words:"damped",sign:"−",tip:"Lost in this copy’s dampers"},{key:"stored",words:"in copy",sign:"−",tip:"In this copy now, as motion and in springs"},{key:"residual",words:"rest",sign:"=",tip:"Rounding"}],Mu=[[1e3,"kJ"],[1,"J"],[.001,"mJ"],[1e-6,"µJ"],[1e-9,"nJ"]];function Bp(i,e){let t=Math.abs(i)/e;return Math.abs(i)<1e-12?"0":Zn(i/e,t>=99.95?0:t>=9.995?1:2)}var px=7;function zp(i,e,t,n){for(;i.children.length>e.length;)i.lastElementChild?.remove();for(;i.children.length<e.length;)i.append(O("div",null,O("span")));e.forEach((s,r)=>{let o=i.children[r],a=t>0?s.value/t:0,l=s.slot===void 0?s.label:`${s.label} of ${n(s.slot)}`;Ge(o,"class",`part part-${s.class}`),o.style.width=`${(100*a).toFixed(2)}%`,s.slot!==void 0&&(o.style.setProperty("--user",`var(--user-${s.slot})`),o.style.setProperty("--on-user",`var(--on-user-${s.slot})`)),Ge(o,"data-tip",`${l}: ${Ws(s.value,"J",1e-12)}`);let c=s.slot===void 0?s.label:String(s.slot+1);o.firstElementChild&&Le(o.firstElementChild,a*i.clientWidth>8+px*c.length?c:"")})}function Gp(i){let{store:e}=i,t=new Map,n=$e("Count from now",()=>{if(t.size)t.clear();else for(let[E,T]of Object.entries(e.state?.members??{}))t.set(Number(E),{...T});M()},{class:"button small",tip:"Leaves out what was before"}),{element:s,body:r}=bi("energy","Energy",ux,n),[o,a]=[O("div",{class:"stack"}),O("div",{class:"stack"})],[l,c]=[O("span",{class:"sum tabular"}),O("span",{class:"sum tabular"})],h=O("th",{scope:"col"}),u=O("tr",null,h,...$r.map(E=>O("th",{scope:"col","data-tip":E.tip,tabindex:0},`${E.sign} ${E.words}`.trim()))),d=O("tbody"),m=$r.map(()=>O("td")),g=O("p",{class:"expected tabular"}),y=O("p",{class:"hint"},"Nothing was booked yet."),p=O("table",{class:"numbers ledger"},O("thead",null,u),d,O("tfoot",null,O("tr",null,O("th",{scope:"row"},"all"),...m))),f=O("div",{hidden:!0},O("div",{class:"bar-row"},O("span",{class:"bar-name"},"came in"),o,l),O("div",{class:"bar-row"},O("span",{class:"bar-name"},"went to"),a,c),g,O("div",{class:"scroll"},p));r.append(y,f);let v=new Map,M=()=>{if(r.offsetParent===null&&v.size)return;let E=Object.entries(e.state?.members??{}).filter(([,q])=>q.steps).map(([q,te])=>{let ce=Number(q),he=t.get(ce)??null;return he&&(te.steps??0)<(he.steps??0)&&t.delete(ce),dx(ce,te,t.get(ce)??null)});dt(f,E.length>0),dt(y,E.length===0),Le(n.firstElementChild??n,t.size?"Count from the start":"Count from now");let T=fx(E),x=q=>q.reduce((te,ce)=>te+ce.value,0),[w,F]=[x(T.came),x(T.went)],N=Math.max(w,F),R=q=>wt(e,q);zp(o,T.came,N,R),zp(a,T.went,N,R),Le(l,Ws(w,"J",1e-12)),Le(c,Ws(F,"J",1e-12));let U=w-F,k=Object.values(e.state?.members??{}),I=Math.max(0,...k.map(q=>q.residual??0)),H=Math.max(0,...k.map(q=>q.closure_factor??0)),Y=H>0?` Balancing steps changed velocities by ${xn(H)} at most.`:"";Ge(g,"data-left",N>0?String(Math.abs(U)/N):null),Le(g,N>0?`Left over: ${Vp(U/N)} of what came in. Worst single step: off by ${Vp(I)} of the energy in play.${Y}`:"");let W=Math.max(1e-9,...E.flatMap(q=>$r.map(te=>Math.abs(q[te.key])))),[le,Z]=Mu.find(([q])=>W>=q)??Mu[Mu.length-1];Le(h,Z);for(let[q,te]of v)E.some(ce=>ce.slot===q)||(te.element.remove(),v.delete(q));for(let q of E){let te=v.get(q.slot);if(!te){let ce=$r.map(()=>O("td")),he=O("tr",null,O("th",{scope:"row",title:R(q.slot)},O("span",{class:"badge tiny",style:`--user:var(--user-${q.slot});--on-user:var(--on-user-${q.slot})`},String(q.slot+1))),...ce);te={element:he,cells:ce},v.set(q.slot,te),d.append(he);for(let Q of[...v.keys()].sort((me,ge)=>me-ge))d.append(v.get(Q)?.element??he)}$r.forEach((ce,he)=>{let Q=te.cells[he];Q&&Le(Q,Bp(q[ce.key],le))})}Ge(p,"data-initial",E.some(q=>q.initial)?"":null),$r.forEach((q,te)=>{let ce=m[te];ce&&Le(ce,Bp(E.reduce((he,Q)=>he+Q[q.key],0),le))})};e.on("state",M);let b=e.scene?.started;return e.on("scene",()=>{e.scene?.started!==b&&t.clear(),b=e.scene?.started,M()}),i.tab.on(M),M(),s}var mx={"-":"⁻",0:"⁰",1:"¹",2:"²",3:"³",4:"⁴",5:"⁵",6:"⁶",7:"⁷",8:"⁸",9:"⁹"};function Vp(i){if(!Number.isFinite(i))return"–";let e=Math.abs(i);if(e===0)return"0";if(e>=.01)return xn(e);let t=Math.floor(Math.log10(e));return`${Math.round(e/10**t)} · 10${[...String(t)].map(n=>mx[n]??"").join("")}`}var gx=200;function Hp(i){let{store:e}=i,{element:t,body:n}=bi("events","Events","What happened in the session: who came and went, links that were guarded, what was asked for. Newest first."),s=O("ol",{class:"events tabular"}),r=O("p",{class:"hint"},"Nothing happened yet.");n.append(r,s);let o=-1/0,a=new Set,l="",c=()=>{let h=e.scene?.started??"";h!==l&&(l=h,[o,a]=[-1/0,new Set],s.replaceChildren());for(let u of e.state?.events??[]){let d=`${u.time} ${u.text}`;u.time<o||a.has(d)||(u.time>o&&a.clear(),o=u.time,a.add(d),s.prepend(O("li",null,O("time",null,ll(u.time)),O("span",null,u.text))))}for(;s.children.length>gx;)s.lastElementChild?.remove();dt(r,!s.children.length)};return e.on("state",c),c(),t}var yx=0;function yr(i,e,t){let n=`dialog-${++yx}`,s=O("dialog",{class:"dialog","aria-labelledby":n}),r=()=>s.close();return s.append(O("div",{class:"panel-head"},O("h2",{id:n},i),O("div",{class:"grow"}),$e("",r,{icon:"close",class:"button bare",label:"Close"})),O("div",{class:"dialog-body"},...e),O("div",{class:"dialog-actions"},...t.map(o=>{let a=$e(o.words,()=>{r(),o.act()},{class:o.class});return o.focus&&(a.autofocus=!0),a}))),s.addEventListener("click",o=>{o.target===s&&r()}),document.body.append(s),{element:s,close:r,open:()=>{s.open||s.showModal()}}}function Wp(i){let e=O("p",null),t=()=>{},n=yr(i,[e],[{words:i,class:"button danger",act:()=>t()},{words:"Cancel",class:"button primary",act:()=>{},focus:!0}]),s=n.element.querySelector("h2");return{ask(r,o,a){s&&Le(s,r),Le(e,o),t=a,n.open()}}}var Su={here:{words:"here",icon:"good"},starting:{words:"starting",icon:"wait"},gone:{words:"gone",icon:"bad"},stopped:{words:"stopped",icon:"bad"},awaited:{words:"not here yet",icon:"wait"},over:{words:"to the end",icon:"tick"}};function Xs(i,e){let t=i?.members[e];return t?i?.ended&&t.here&&t.steps?"over":t.alive===!1?"stopped":t.here?t.steps?"here":"starting":t.alive?"starting":t.steps?"gone":"awaited":"awaited"}var li={coupled:{words:"coupled",means:"Both ends feel each other through the spring.",icon:"good"},catching:{words:"catching up",means:"The end has caught up and shows that it can be relied on; it couples when both have.",icon:"wait"},guarded:{words:"guarded",means:"News is older than its budget, or was. The end moves its spring only as far as its saved energy pays for.",icon:"warn"},waiting:{words:"waiting",means:"Nothing is heard.",icon:"wait"},cut:{words:"cut",means:"Nothing gets through. Each end lets go of its spring without a kick.",icon:"bad"},off:{words:"not linked",means:"These two are not joined directly.",icon:"minus"}},vx={coupled:"coupled",ready:"catching",guarded:"guarded",waiting:"waiting",keys:"waiting"};function cl(i){return i?vx[i.state]??"waiting":"waiting"}var xx=["cut","guarded","waiting","catching","coupled"];function qs(i,e,t){if(!i)return"waiting";if(Yr(i,e,t))return"cut";if(!i.links.some(([s,r])=>s===e&&r===t||s===t&&r===e))return"off";let n=[cl(i.ends[`${e}-${t}`]),cl(i.ends[`${t}-${e}`])];return xx.find(s=>n.includes(s))??"waiting"}function Yr(i,e,t){return!!(i.emulated[`${e}-${t}`]?.cut||i.emulated[`${t}-${e}`]?.cut)}function Ii(i,e,t,n){let s=[i?.ends[`${e}-${t}`]?.[n],i?.ends[`${t}-${e}`]?.[n]].filter(r=>typeof r=="number");return s.length?Math.max(...s):null}function hl(i,e,t){let[n,s]=[Ii(i,e,t,"ages"),Ii(i,e,t,"budget")];return n===null||s===null||s<=0?null:1-n/s}var Xp={script:"follows the script",free:"hand free",hold:"holds still",pull:"pulls",wander:"wanders",grab:"pointer grabs",ball:"pointer pushes",elsewhere:"on another computer"};async function qp(i,e,t){try{await navigator.clipboard.writeText(e),i.say(`${t} copied.`,"good")}catch{i.say("The browser does not let this page copy; mark the text and copy it yourself.","warn")}}function _x(i){return/^[\w.-]+$/.test(i)?i:`'${i.replaceAll("'","'\\''")}'`}function $p(i){let{store:e,connection:t}=i,n=O("textarea",{readonly:!0,rows:3,"aria-label":"Invitation",spellcheck:"false"}),s=O("textarea",{readonly:!0,rows:1,"aria-label":"Command",spellcheck:"false"}),r=O("select",{"aria-label":"Whose place"}),o=O("p",{class:"hint",role:"status"}),a=O("img",{alt:"The address of this page as a QR code",width:168,height:168,class:"qr"}),l=O("figcaption",null),c=O("figure",{class:"qr-frame"},a,l),h=O("p",{class:"hint"},"Only this computer can open this page. To open it on a phone by a QR code, start cotouch with --page-listen and the address of this computer."),u=$e("Free this place",()=>{let y=Number(r.value);i.act({what:"expel",slot:y})},{class:"button small danger",icon:"stop"}),d=O("p",{class:"hint"},"Whoever has the invitation can take part: give it only to those you trust. The other computer must reach this one over the network."),m=yr("Invite",[O("div",{class:"invite"},O("div",{class:"invite-words"},O("label",{class:"field"},O("span",null,"1. Whose place shall be taken?"),O("span",{class:"row"},r,u)),o,O("div",{class:"field"},O("span",null,"2. On the other computer, type"),s,O("span",{class:"row"},$e("Copy the command",()=>{qp(i,s.value,"Command")},{class:"button small"}))),O("div",{class:"field"},O("span",null,"3. There, paste the invitation"),n,O("span",{class:"row"},$e("Copy the invitation",()=>{qp(i,n.value,"Invitation")},{class:"button small primary"})))),c),d,h],[]),g=()=>{if(!m.element.open)return;let y=e.scene?.invitation??"",p=Number(r.value);n.value!==y&&(n.value=y);let f=`cotouch join - --name ${_x(wt(e,p))}`;s.value!==f&&(s.value=f);let v=Xs(e.state,p),M=v==="here"||v==="starting",b=e.state?.members[p]?.alive===null;if(dt(c,!!e.scene?.page),dt(h,!e.scene?.page),e.scene?.page){let E=t.link("qr.svg",{user:String(p+1)});a.getAttribute("src")!==E&&(a.src=E),Le(l,`opens this page on a phone, as ${wt(e,p)}`)}Le(o,b&&M?`${wt(e,p)} is played on another computer. If you free the place, whoever plays there is sent away for the rest of the session.`:M?`${wt(e,p)} is played by a process here. Free the place first; the object stays, and whoever joins with this name takes it.`:`The place of ${wt(e,p)} is free.`),dt(u,M),u.disabled=!Et(i,"expel")};return r.addEventListener("change",g),e.on("state",g),e.on("scene",g),{open:()=>{if(!e.scene?.invitation)return;let y=e.scene.users,p=r.value;r.replaceChildren(...y.map(v=>O("option",{value:v.slot},`${v.slot+1} · ${v.name}`)));let f=y.find(v=>!["here","starting"].includes(Xs(e.state,v.slot)))??y.at(-1);r.value=p||String(f?.slot??0),m.open(),g()}}}var bx="Every user moves a copy of the object in a process of its own, at its own rate. A step that comes too late is left out; the next is then longer, and energy stays exact. Force is what the hand exerts on its copy. Unfold a user to tell its hand what to do, to stop its process, or to act as that user.",Yp=[{value:"script",words:"Script",tip:"Move as the session’s file says"},{value:"hold",words:"Hold",tip:"Keep what is held where it is now"},{value:"free",words:"Let go",tip:"Hold nothing"},{value:"wander",words:"Wander",tip:"Move it about slowly"},{value:"pull",words:"Pull …",tip:"Drag it to a place"}],Mx=[{words:"−x",label:"back, −x",to:[-1,0,0],from:1},{words:"+x",label:"forward, +x",to:[1,0,0],from:1},{words:"−y",label:"right, −y",to:[0,-1,0],from:2},{words:"+y",label:"left, +y",to:[0,1,0],from:2},{words:"−z",label:"down, −z",to:[0,0,-1],from:3},{words:"+z",label:"up, +z",to:[0,0,1],from:3}];function wu(i,e){let t=O("dd",null,"–");return{element:O("div",{class:"metric","data-tip":e},O("dt",null,i),t),value:t}}function ul(i){let e=new URL(location.href);return e.searchParams.set("user",String(i+1)),e.href}function Sx(i,e,t){let{store:n}=i,s=!!n.scene?.own.includes(e),r=()=>n.me===e,o=vn("wait",14),a=O("span",{class:"presence-words"}),l=O("span",{class:"chip chip-mine",hidden:!0},"you"),c=O("span",{class:"hand-mode"}),h=wu("rate","Steps per second"),u=wu("late","Share of the steps that were due and were left out, since the start"),d=wu("force","Of the hand on its copy"),m=`user-${e}-more`,g=O("button",{type:"button",class:"user-head","aria-expanded":"false","aria-controls":m},O("span",{class:"badge",style:`--user:var(--user-${e});--on-user:var(--on-user-${e})`},String(e+1)),O("span",{class:"user-name",style:`--user:var(--user-${e})`},wt(n,e)),l,O("span",{class:"grow"}),O("span",{class:"presence"},o,a));g.addEventListener("click",()=>i.opened.set(i.opened.get()===e?null:e));let y=O("div",{class:"pulls",hidden:!0}),p=(R,U={})=>{i.aiming.set(null),i.act({what:"hand",slot:e,mode:R,...U})},f=gr(`Hand of ${wt(n,e)}`,Yp,R=>{R!=="pull"?(y.hidden=!0,p(R)):(y.hidden=!y.hidden,i.aiming.set(y.hidden?null:{slot:e}))});y.append(O("p",{class:"hint"},"Click in the picture where to pull, or choose a direction:"),O("div",{class:"directions",role:"group","aria-label":"Direction to pull"},...Mx.filter(R=>R.from<=(n.scene?.dimension??1)).map(R=>$e(R.words,()=>{let U=Ip(i,e,R.to);U&&p("pull",U)},{class:"button small",label:`Pull ${R.label}`}))));let v=$e("Take over",()=>{n.take(e),history.replaceState(null,"",ul(e)),i.say(`This page now acts as ${wt(n,e)}.`)},{class:"button small",tip:"Your pointer moves this user’s hand"}),M=$e("New window",()=>{open(ul(e),"_blank","noopener")},{class:"button small",tip:"Open another page that acts as this user"}),b=$e("Stop process",()=>{i.act({what:"kill",slot:e})},{class:"button small danger",icon:"stop",tip:"Ends this user’s process at once, as a crash would"}),E=$e("Send away …",()=>{let R=wt(n,e);t.ask(`Send ${R} away?`,`${R} takes part from another computer. The place becomes free at once, and whoever is sent away cannot come back for the rest of the session.`,()=>{i.act({what:"expel",slot:e})})},{class:"button small danger",icon:"stop",tip:"Sends away who plays this user on another computer"}),T=$e("Bring back",()=>{i.act({what:"revive",slot:e})},{class:"button small",icon:"reset"}),x=[v,M,b,E,T],w=O("div",{class:"user-more",id:m,hidden:!0},f.element,y,O("div",{class:"actions"},...x)),F=O("li",{class:"user","data-slot":e},g,O("dl",{class:"metrics"},h.element,u.element,d.element),c,w);return{element:F,update:()=>{let R=n.state?.members[e],U=Xs(n.state,e);On(o,Su[U].icon),Le(a,Su[U].words),Ge(F,"data-presence",U),dt(l,r()),Ge(F,"data-mine",r()?"":null);let k=U==="here"||U==="over"?R:void 0;Le(h.value,al(k?.rate));let I=k?.missed??0,H=(k?.steps??0)+I;Le(u.value,H?xn(I/H):"–"),Ge(u.element,"data-tip",H?`${sa(I)} of ${sa(H)} steps that were due came too late and were left out`:null),Le(d.value,ol(k?.force)),Le(c,k?Xp[k.hand??"elsewhere"]??"":""),f.mark(k&&s?k.hand:null);let Y=i.opened.get()===e;Ge(g,"aria-expanded",String(Y)),dt(w,Y),Y||(y.hidden=!0,i.aiming.get()?.slot===e&&i.aiming.set(null));let W=Et(i,"hand")&&s&&U==="here";for(let q of Yp)f.allow(q.value,W);v.disabled=!s||!i.connection.hasToken||n.slot===e,M.disabled=!s;let le=U==="stopped"||U==="gone"&&s,Z=!!R?.here&&R.alive===null;dt(E,Z&&!!n.scene?.may.includes("expel")),E.disabled=!Et(i,"expel"),dt(b,!le&&!(s&&Z)),dt(T,le),b.disabled=!Et(i,"kill")||!s||U==="awaited",T.disabled=!Et(i,"revive")||!s}}}function Jp(i){let{store:e}=i,t=O("span",{class:"panel-note"}),{element:n,body:s}=bi("users","Users",bx,t),r=O("ul",{class:"users"}),o=Wp("Send away");s.append(r);let a=[],l=()=>{for(let d of a)d.update();let u=e.scene?.users??[];Le(t,u.length?`${u.filter(d=>["here","over"].includes(Xs(e.state,d.slot))).length} of ${u.length} here`:"")},c="",h=()=>{let u=e.scene,d=u?JSON.stringify([u.started,u.users,u.own,u.dimension]):"";if(d===c)return l();c=d,a=(u?.users??[]).map(m=>Sx(i,m.slot,o)),r.replaceChildren(...a.map(m=>m.element)),l()};e.on("scene",h);for(let u of["state","slot","connection"])e.on(u,l);return i.opened.on(l),h(),n}var Zp="cotouch.keys",Eu=["displacement","stress","plain"],wx=[["1 … 8","act as this user"],["G","grab the nearest point; arrows move it, Esc lets go"],["B","grab or push with the ball"],["S","copies overlaid or side by side"],["C","what colours show"],["0","look from the start again"],["F","freeze the plots"],["R","record, stop"],["I","invite"],["T","tour: ← → for steps, Esc leaves"],["D","theme"],["Tab, Enter","reach and open everything, links as well"],["+ −","delay of the link that has the focus"],["?","this page"]];function Ex(i){return i instanceof Element&&i.closest("input, textarea, select, [contenteditable]")!==null}function Kp(i,e){let{store:t}=i,n=!1;try{n=localStorage.getItem(Zp)==="off"}catch{}let s=O("input",{type:"checkbox"});s.checked=!n,s.addEventListener("change",()=>{n=!s.checked;try{localStorage.setItem(Zp,n?"off":"on")}catch{}});let r=yr("Keyboard",[O("dl",{class:"keys"},...wx.flatMap(([a,l])=>[O("dt",null,...a.split(" ").map(c=>c==="…"?" … ":O("kbd",null,c))),O("dd",null,l)])),O("label",{class:"check"},s,O("span",null,"Single keys do these things"))],[]),o={b:()=>t.set({tool:t.settings.tool==="grab"?"ball":"grab"}),s:()=>t.set({layout:t.settings.layout==="overlay"?"side":"overlay"}),c:()=>t.set({colour:Eu[(Eu.indexOf(t.settings.colour)+1)%Eu.length]??"plain"}),0:e.reset,f:e.freeze,r:e.record,i:e.invite,t:e.tour,d:()=>bu(t)};return document.addEventListener("keydown",a=>{if(a.defaultPrevented||a.ctrlKey||a.metaKey||a.altKey||a.repeat||Ex(a.target)||document.querySelector("dialog[open]"))return;if(a.key==="?")return a.preventDefault(),r.open();if(n)return;let l=Number(a.key)-1;if(a.key.length===1&&l>=0&&l<8){if(!t.scene?.own.includes(l)){t.scene?.users.some(c=>c.slot===l)&&i.say(`${wt(t,l)} moves elsewhere; this page cannot act for that user.`,"warn");return}t.take(l),history.replaceState(null,"",ul(l)),i.say(`This page now acts as ${wt(t,l)}.`);return}o[a.key.toLowerCase()]?.()}),{open:r.open}}var jp={x:180,y:126},Tx=[.5,.42,.58,.34,.66,.28,.72];function Qp(i){let[e,t]=i===2?[104,0]:[104,92];return Array.from({length:i},(n,s)=>{let r=2*Math.PI*s/i+(i===2?Math.PI:-Math.PI/2);return{x:jp.x+e*Math.cos(r),y:jp.y+t*Math.sin(r)}})}function dl(i,e,t){return{x:i.x+(e.x-i.x)*t,y:i.y+(e.y-i.y)*t}}function em(i,e){let t=[];return i.map(([n,s])=>{let[r,o]=[e[n],e[s]];if(!r||!o)return .5;let a=.5,l=-1/0;for(let c of Tx){let h=dl(r,o,c),u=Math.min(40-40*Math.abs(c-.5),...t.map(d=>Math.hypot((h.x-d.x)*.62,(h.y-d.y)*1.5)),...e.map(d=>Math.hypot(h.x-d.x,h.y-d.y)-6));u>l+.5&&([l,a]=[u,c])}return t.push(dl(r,o,a)),a})}function tm(i,e){let t=new Set(i.slice(0,1));for(let n=!0;n;){n=!1;for(let[s,r]of e)t.has(s)!==t.has(r)&&(t.add(s).add(r),n=!0)}return i.filter(n=>!t.has(n))}function nm(i){return i.flatMap((e,t)=>i.slice(t+1).map(n=>e<n?[e,n]:[n,e]))}var Tu={start:"As the session began.",best:"Differences between copies fade fastest over these links.",worst:"As many links, but differences fade slowest: watch the copies come back late.",yours:"Click the lines between users to join or part them, then apply."};function Ax(i,e,t){for(let[n,s]of[[e,t],[t,e]]){let r=i.members[n]?.round_trips?.find(([a])=>a===s)?.[1],o=i.ends[`${n}-${s}`]?.round_trip??r;if(typeof o=="number")return Math.max(o,0)}return null}function im(i,e){let t=new Map,n=0;for(let[s,r]of e){let o=Ax(i,s,r);if(o===null)return null;n+=o;for(let a of[s,r])t.set(a,(t.get(a)??0)+o)}return e.length?{mean:n/e.length,most:Math.max(...t.values())}:null}var Au=i=>(i[0]??"").toUpperCase()+i.slice(1);function fl(i,e){let t=new Set(i.map(Jn));return i.length===e.length&&e.every(n=>t.has(Jn(n)))}var ra=i=>i.map(([e,t])=>ji(e,t));function sm(i,e,t,n){let{store:s}=i,r=!1,o=null,a=O("p",{class:"means"}),l=O("p",{class:"expected tabular"}),c=O("p",{class:"problem",role:"status",hidden:!0}),h=M=>M==="yours"?[...e].map(b=>b.split("-").map(Number)):ra(s.state?.choices[M]??[]),u=M=>{if(r=M,e.clear(),M)for(let b of ra(s.state?.links??[]))e.add(Jn(b));t(M)},d=M=>{o=M,M==="yours"?r||u(!0):(r&&u(!1),i.act({what:"links",choice:M})),n()},m=M=>!!s.state&&M in s.state.choices,g=gr("Links",["start","best","worst","yours"].map(M=>({value:M,words:Au(M),tip:Tu[M]})),d),y=$e("Apply",()=>{let M=h("yours");i.act({what:"links",links:M}).then(b=>{b&&u(!1)})},{class:"button small primary"}),p=$e("Cancel",()=>{o=null,u(!1)},{class:"button small"}),f=O("div",{class:"actions",hidden:!0},y,p),v=()=>{let M=s.state,b=ra(M?.links??[]);for(let I of["start","best","worst"]){let H=!m(I)&&Et(i,"links");g.allow(I,Et(i,"links")&&h(I).length>0),g.say(I,H?`${Au(I)} …`:Au(I),H?"Being worked out; this takes some seconds.":m(I)&&!h(I).length?"None was found.":Tu[I])}g.allow("yours",Et(i,"links"));let E=r?"yours":o&&o!=="yours"&&fl(h(o),b)?o:["start","best","worst"].find(I=>h(I).length&&fl(h(I),b))??(b.length?"yours":null);g.mark(E);let T=r?h("yours"):b,x=Et(i,"links")&&!(m("best")&&m("worst")),w=Object.keys(M?.choices??{}).length>0;dt(g.element,w||Et(i,"links"));let F=E&&(w||r)?E==="yours"&&!r?"Links of your own.":Tu[E]:"";Le(a,x&&!r?`${F} Best and worst are being worked out.`.trim():F);let[N,R]=M?[im(M,ra(M.choices.start??M.links)),im(M,T)]:[null,null],U=T.length?`${T.length} ${T.length===1?"link":"links"}`:"";R&&(U+=`, mean way there and back ${kn(R.mean)}`),N&&R&&N.most>0&&!fl(T,ra(M?.choices.start??[]))&&(U+=`. The busiest user needs about ${Zn(R.most/N.most,1)} × the damping of the start, if springs are alike`),Le(l,U&&`${U}.`),dt(f,r);let k=r?tm((s.scene?.users??[]).map(I=>I.slot),T):[];Le(c,k.length?`No way leads to ${k.map(I=>wt(s,I)).join(", ")}.`:""),dt(c,k.length>0),y.disabled=k.length>0||fl(T,b)||!Et(i,"links"),Ge(g.element,"data-drafting",r?"":null)};return{element:O("div",{class:"topology",id:"topology"},g.element,a,l,c,f),update:v,changed:n}}var Cx="Who is joined to whom. A number on a link is the age of what its slower end knows of the other, and the share of samples that got lost. Choose a link to see both its ends and to delay, disturb or cut it; drag it sideways to change its delay (1 ms for each point; with the keyboard + and −).",rm=.005,om=.5,Rx=100;function Ru(i){let e=null,t=0,n=()=>{if(t=0,e===null)return;let s=e;e=null,t=window.setTimeout(n,Rx),i(s)};return s=>{e=s,t||n()}}function Px(i,e,t,n,s){let{store:r}=i,[o,a]=e,[l,c]=[t[o]??{x:0,y:0},t[a]??{x:0,y:0}],h={x1:l.x,y1:l.y,x2:c.x,y2:c.y},u=dl(l,c,n),d=Jt("line",{...h,class:"link-line"}),m=Jt("text",{x:u.x,y:u.y+3.5,class:"link-words"}),g=Jt("rect",{class:"link-plate",rx:4,y:u.y-9,height:18}),y=Jt("g",{class:"link",tabindex:0,role:"button","data-link":Jn(e)},Jt("line",{...h,class:"link-halo"}),d,Jt("line",{...h,class:"link-hit"}),g,m),p=()=>r.state?.emulated[`${o}-${a}`]?.delay??0,f=Ru(x=>{i.act({what:"impair",a:o,b:a,delay:x},!0)}),v=null,M=null;y.addEventListener("pointerdown",x=>{s()||x.button!==0||(M={x:x.clientX,delay:p()},y.setPointerCapture(x.pointerId))}),y.addEventListener("pointermove",x=>{if(!M)return;let w=x.clientX-M.x;v===null&&(Math.abs(w)<4||!Et(i,"impair"))||(v=Math.min(Math.max(M.delay+w*.001,0),om),f(v),T())});let b=x=>{let w=v!==null,F=M!==null;M=v=null,!w&&F&&x.type==="pointerup"&&i.link.set(Qi(i.link.get(),e)?null:e),T()};y.addEventListener("pointerup",b),y.addEventListener("pointercancel",b);let E=0;y.addEventListener("keydown",x=>{if(!s()){if(x.key==="Enter"||x.key===" ")i.link.set(Qi(i.link.get(),e)?null:e),document.getElementById("link")?.focus();else if("+-=−".includes(x.key)&&Et(i,"impair"))E=Math.min(Math.max(p()+(x.key==="+"||x.key==="="?rm:-rm),0),om),f(E);else return;x.preventDefault(),x.stopPropagation()}});let T=()=>{let x=qs(r.state,o,a),w=Ii(r.state,o,a,"age"),F=Ii(r.state,o,a,"loss");Ge(y,"data-condition",x),Ge(y,"data-chosen",Qi(i.link.get(),e)?"":null),Ge(y,"data-drawn",v===null?null:"");let N=v!==null?`+${kn(v)} each way`:x==="coupled"||x==="catching"||x==="guarded"?[w===null?"":kn(Math.max(w,0)),F!==null&&F>=5e-4?xn(F):""].filter(Boolean).join(" · ")||"–":li[x].words,R={guarded:"! ",cut:"✕ ",waiting:"… ",catching:"… "}[x]??"",U=v===null?R+N:N;Le(m,U);let k=12+U.length*6.1;Ge(g,"x",(u.x-k/2).toFixed(1)),Ge(g,"width",k.toFixed(1)),Ge(y,"aria-label",`Link ${ts(o,a)}, ${li[x].words}, age ${kn(w)}, loss ${xn(F)}`),Ge(y,"aria-pressed",String(Qi(i.link.get(),e)))};return{group:y,update:T}}function Ix(i,e,t){let{store:n}=i,s=wt(n,e),r=Math.abs(t.x-360/2)>80,o=t.x>360/2,a=r?10:16,l=s.length>a?`${s.slice(0,a-1)}…`:s,c=r?{x:t.x+(o?1:-1)*24,y:t.y+4,anchor:o?"start":"end"}:{x:t.x,y:t.y+(t.y<248/2?-23:32),anchor:"middle"},h=Jt("g",{class:"node",style:`--user:var(--user-${e});--on-user:var(--on-user-${e})`,"data-slot":e},Jt("title",null,s),Jt("circle",{cx:t.x,cy:t.y,r:20,class:"node-mine"}),Jt("circle",{cx:t.x,cy:t.y,r:16,class:"node-disc"}),Jt("text",{x:t.x,y:t.y+4.5,class:"node-number"},String(e+1)),Jt("text",{x:c.x,y:c.y,"text-anchor":c.anchor,class:"node-name"},l));return h.addEventListener("click",()=>{i.opened.set(e),i.tab.set("users")}),{group:h,update:()=>{Ge(h,"data-presence",Xs(n.state,e)),Ge(h,"data-mine",n.me===e?"":null)}}}function Lx(i,e,t,n){let[s,r]=[t[e[0]]??{x:0,y:0},t[e[1]]??{x:0,y:0}],o={x1:s.x,y1:s.y,x2:r.x,y2:r.y},a=Jn(e),l=Jt("g",{class:"pair",tabindex:0,role:"checkbox","aria-label":`Link ${ts(...e)}`,"data-link":a},Jt("line",{...o,class:"pair-line"}),Jt("line",{...o,class:"link-hit"})),c=()=>{i.delete(a)||i.add(a),n()};return l.addEventListener("click",c),l.addEventListener("keydown",h=>{h.key!=="Enter"&&h.key!==" "||(h.preventDefault(),c())}),{group:l,update:()=>Ge(l,"aria-checked",String(i.has(a)))}}function lm(i){let{store:e}=i,{element:t,body:n}=bi("network","Network",Cx),s=Jt("svg",{viewBox:`0 0 ${360} ${248}`,class:"graph",role:"group","aria-label":"Users and links"}),r=O("ul",{class:"legend"},...["coupled","guarded","cut"].map(d=>O("li",{"data-condition":d,"data-tip":li[d].means,tabindex:0},vn(li[d].icon,12),li[d].words))),o=new Set,a=!1,l=[],c="",h=()=>{let d=(e.scene?.users??[]).map(y=>y.slot),m=(e.state?.links??[]).map(([y,p])=>ji(y,p)),g=JSON.stringify([a,e.scene?.started,e.scene?.users,m]);if(g!==c){c=g;let y=document.activeElement?.closest("[data-link]")?.dataset.link,p=[];Qp(d.length).forEach((b,E)=>{p[d[E]??E]=b});let f=em(m,p);l=[...a?nm(d).map(b=>Lx(o,b,p,()=>u.changed())):m.map((b,E)=>Px(i,b,p,f[E]??.5,()=>a)),...d.map(b=>Ix(i,b,p[b]??{x:0,y:0}))],s.replaceChildren(...l.map(b=>b.group)),Ge(s,"data-drafting",a?"":null),y&&s.querySelector(`[data-link="${y}"]`)?.focus();let M=i.link.get();M&&!m.some(b=>Qi(b,M))&&i.link.set(null)}for(let y of l)y.update();u.update(),dt(r,!a)},u=sm(i,o,d=>{a=d,d&&i.link.set(null),h()},()=>h());n.append(s,r,u.element);for(let d of["scene","state","slot","connection"])e.on(d,h);return i.link.on(h),h(),t}var Pu=[{words:"state",tip:"What this end does with its spring",show:i=>li[cl(i)].words},{words:"age",tip:"Of the newest sample in the last step, up to the offset of the two clocks",show:i=>kn(i.age)},{words:"both ages",tip:"Greatest sum of the ages at both ends in the window; here clocks cancel",show:i=>kn(i.ages)},{words:"budget",tip:"What the damping is made for: the sum of ages that may be",show:i=>kn(i.budget)},{words:"way",tip:"Quickest way there and back",show:i=>`${kn(i.round_trip)} ${i.path_state}`},{words:"loss",tip:"Share of what the neighbour sent that did not come",show:i=>xn(i.loss)},{words:"samples",tip:"Sent to the neighbour per second",show:i=>al(i.rate)},{words:"force",tip:"Of the link’s spring on this copy",show:i=>ol(i.force)},{words:"work",tip:"Of the link on this copy since the start",show:i=>Ws(i.work,"J")},{words:"apart",tip:"Greatest difference between the copies, as far as known",show:i=>Dp(i.difference)},{words:"guarded",tip:"How often the link was guarded",show:i=>`${sa(i.guarded)} ×`}];function Iu(i,e,t,n){let s=O("output",{class:"tabular"},t.show(0)),r=O("input",{type:"range",min:0,max:t.most,step:t.step,value:0,"aria-label":i}),o=-1/0,a=Ru(n),l=()=>{let c=Number(r.value);Le(s,t.show(c)),Ge(r,"aria-valuetext",t.show(c)),r.style.setProperty("--share",`${100*c/t.most}%`)};return r.addEventListener("input",()=>{o=performance.now(),l(),a(Number(r.value))}),{element:O("label",{class:"slider","data-tip":e},O("span",null,i),r,s),set(c){performance.now()-o<1e3||Number(r.value)===c||(r.value=String(c),l())},enable(c){r.disabled=!c}}}function cm(i){let{store:e}=i,t=[0,1],n=O("h2",{id:"link-title",class:"tabular"}),s=vn("good",14),r=O("strong",null),o=O("span",{class:"means"}),a=O("p",{class:"expected tabular"}),l=v=>M=>{i.act({what:"impair",a:t[0],b:t[1],[v]:M},!0)},c={delay:Iu("delay","Added to every sample, each way",{most:.5,step:.005,show:kn},l("delay")),jitter:Iu("jitter","Scale of what comes on top of the delay by chance",{most:.1,step:.002,show:kn},l("jitter")),loss:Iu("loss","Share of samples thrown away",{most:.5,step:.01,show:v=>xn(v,0)},l("loss"))},h=$e("Cut",()=>{let v=!(e.state&&Yr(e.state,...t));i.act({what:"cut",a:t[0],b:t[1],on:v})},{icon:"cut",class:"button",id:"cut"}),u=$e("Clear",()=>{i.act({what:"impair",a:t[0],b:t[1],delay:0,jitter:0,loss:0})},{class:"button",icon:"reset",tip:"No added delay, jitter or loss"}),d=[O("th",{scope:"col"}),O("th",{scope:"col"})],m=Pu.map(()=>[O("td"),O("td")]),g=O("table",{class:"numbers"},O("thead",null,O("tr",null,O("td"),...d)),O("tbody",null,...Pu.map((v,M)=>O("tr",null,O("th",{scope:"row","data-tip":v.tip,tabindex:0},v.words),...m[M]??[])))),y=$e("",()=>i.link.set(null),{icon:"close",class:"button bare",label:"Close the link’s card"}),p=O("aside",{id:"link",class:"card","aria-labelledby":"link-title",tabindex:-1,hidden:!0},O("div",{class:"panel-head"},n,O("div",{class:"grow"}),y),O("p",{class:"condition"},s,r," ",o),a,c.delay.element,c.jitter.element,c.loss.element,O("div",{class:"actions"},h,u),g);p.addEventListener("keydown",v=>{if(v.key!=="Escape")return;let M=document.querySelector(`.link[data-link="${t.join("-")}"]`);i.link.set(null),M?.focus(),v.stopPropagation()});let f=()=>{let v=i.link.get();if(dt(p,v!==null),!v)return;t=v;let[M,b]=t,E=qs(e.state,M,b);Le(n,`Link ${ts(M,b)}`),Ge(p,"data-condition",E),On(s,li[E].icon),Le(r,li[E].words),Le(o,li[E].means);let T=hl(e.state,M,b);Le(a,T===null||E==="cut"?"":T>=0?`${xn(T,0)} of the budget of ages to spare.`:`Ages are ${xn(-T,0)} over the budget.`);let x=e.state?.emulated[`${M}-${b}`];c.delay.set(x?.delay??0),c.jitter.set(x?.jitter??0),c.loss.set(x?.loss??0);for(let N of Object.values(c))N.enable(Et(i,"impair"));u.disabled=!Et(i,"impair");let w=!!e.state&&Yr(e.state,M,b);Le(h.lastElementChild??h,w?"Mend":"Cut");let F=h.querySelector("svg");F&&On(F,w?"mend":"cut"),Ge(h,"class",w?"button primary":"button danger"),h.disabled=!Et(i,"cut"),[[M,b],[b,M]].forEach(([N,R],U)=>{let k=d[U];k&&(Le(k,`at ${(N??0)+1}`),Ge(k,"title",wt(e,N??0)),k.style.setProperty("--user",`var(--user-${N})`));let I=e.state?.ends[`${N}-${R}`];Pu.forEach((H,Y)=>{let W=m[Y]?.[U];W&&Le(W,I?H.show(I):"–")})})};return e.on("state",f),e.on("scene",f),e.on("connection",f),i.link.on(v=>{f(),v&&(p.scrollTop=0)}),p}var Nx="uplot",Dx="u-hz",Ux="u-vt",Fx="u-title",Ox="u-wrap",kx="u-under",Bx="u-over",zx="u-axis",_r="u-off",Vx="u-select",Gx="u-cursor-x",Hx="u-cursor-y",Wx="u-cursor-pt",Xx="u-legend",qx="u-live",$x="u-inline",Yx="u-series",Jx="u-marker",hm="u-label",Zx="u-value",la="width",ca="height";var um="bottom",Jr="left",Lu="right",Ju="#000",dm=Ju+"0",Nu="mousemove",fm="mousedown",Du="mouseup",pm="mouseenter",mm="mouseleave",gm="dblclick",Kx="resize",jx="scroll",ym="change",vl="dppxchange",Zu="--",no=typeof window<"u",Bu=no?document:null,Kr=no?window:null,Qx=no?navigator:null,Ct,pl;function zu(){let i=devicePixelRatio;Ct!=i&&(Ct=i,pl&&Gu(ym,pl,zu),pl=matchMedia(`(min-resolution: ${Ct-.001}dppx) and (max-resolution: ${Ct+.001}dppx)`),br(ym,pl,zu),Kr.dispatchEvent(new CustomEvent(vl)))}function ci(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function Vu(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Xt(i,e,t){i.style[e]=t+"px"}function Li(i,e,t,n){let s=Bu.createElement(i);return e!=null&&ci(s,e),t?.insertBefore(s,n),s}function Si(i,e){return Li("div",i,e)}var vm=new WeakMap;function is(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=vm.get(i);r!=o&&(i.style.transform=r,vm.set(i,r),e<0||t<0||e>n||t>s?ci(i,_r):Vu(i,_r))}var xm=new WeakMap;function _m(i,e,t){let n=e+t,s=xm.get(i);n!=s&&(xm.set(i,n),i.style.background=e,i.style.borderColor=t)}var bm=new WeakMap;function Mm(i,e,t,n){let s=e+""+t,r=bm.get(i);s!=r&&(bm.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var Ku={passive:!0},e_={...Ku,capture:!0};function br(i,e,t,n){e.addEventListener(i,t,n?e_:Ku)}function Gu(i,e,t,n){e.removeEventListener(i,t,Ku)}no&&zu();function Ni(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:hi((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function Zm(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var Km=i=>i!=null,jm=i=>i!=null&&i>0,bl=Zm(Km),t_=Zm(jm);function n_(i,e,t,n=0,s=!1){let r=s?t_:bl,o=s?jm:Km;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??Ot,l??-Ot]}function Ml(i,e,t,n){let s=Em(i),r=Em(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?ys:Qm,a=s==1?hi:wi,l=r==1?wi:hi,c=a(o(bn(i))),h=l(o(bn(e))),u=jr(t,c),d=jr(t,h);return t==10&&(c<0&&(u=kt(u,-c)),h<0&&(d=kt(d,-h))),n||t==2?(i=u*s,e=d*r):(i=ig(i,u),e=Sl(e,d)),[i,e]}function ju(i,e,t,n){let s=Ml(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var Qu=.1,Sm={mode:3,pad:Qu},ua={pad:0,soft:null,mode:0},i_={min:ua,max:ua};function xl(i,e,t,n){return wl(t)?wm(i,e,t):(ua.pad=t,ua.soft=n?0:null,ua.mode=n?3:0,wm(i,e,i_))}function Tt(i,e){return i??e}function s_(i,e,t){for(e=Tt(e,0),t=Tt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function wm(i,e,t){let n=t.min,s=t.max,r=Tt(n.pad,0),o=Tt(s.pad,0),a=Tt(n.hard,-Ot),l=Tt(s.hard,Ot),c=Tt(n.soft,Ot),h=Tt(s.soft,-Ot),u=Tt(n.mode,0),d=Tt(s.mode,0),m=e-i,g=ys(m),y=Kn(bn(i),bn(e)),p=ys(y),f=bn(p-g);(m<1e-24||f>10)&&(m=0,(i==0||e==0)&&(m=1e-24,u==2&&c!=Ot&&(r=0),d==2&&h!=-Ot&&(o=0)));let v=m||y||1e3,M=ys(v),b=jr(10,hi(M)),E=v*(m==0?i==0?.1:1:r),T=kt(ig(i-E,b/10),24),x=i>=c&&(u==1||u==3&&T<=c||u==2&&T>=c)?c:Ot,w=Kn(a,T<x&&i>=x?x:Di(x,T)),F=v*(m==0?e==0?.1:1:o),N=kt(Sl(e+F,b/10),24),R=e<=h&&(d==1||d==3&&N>=h||d==2&&N<=h)?h:-Ot,U=Di(l,N>R&&e<=R?R:Kn(R,N));return w==U&&w==0&&(U=100),[w,U]}var r_=new Intl.NumberFormat(no?Qx.language:"en-US"),ed=i=>r_.format(i),ui=Math,yl=ui.PI,bn=ui.abs,hi=ui.floor,_n=ui.round,wi=ui.ceil,Di=ui.min,Kn=ui.max,jr=ui.pow,Em=ui.sign,ys=ui.log10,Qm=ui.log2,o_=(i,e=1)=>ui.sinh(i)*e,Uu=(i,e=1)=>ui.asinh(i/e),Ot=1/0;function Tm(i){return(ys((i^i>>31)-(i>>31))|0)+1}function Hu(i,e,t){return Di(Kn(i,e),t)}function eg(i){return typeof i=="function"}function yt(i){return eg(i)?i:()=>i}var a_=()=>{},tg=i=>i,ng=(i,e)=>e,l_=i=>null,Am=i=>!0,Cm=(i,e)=>i==e,c_=/\.\d*?(?=9{6,}|0{6,})/gm,Mr=i=>{if(rg(i)||Ys.has(i))return i;let e=`${i}`,t=e.match(c_);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Mr(s)}e${r}`}return kt(i,n)};function vr(i,e){return Mr(kt(Mr(i/e))*e)}function Sl(i,e){return Mr(wi(Mr(i/e))*e)}function ig(i,e){return Mr(hi(Mr(i/e))*e)}function kt(i,e=0){if(rg(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return _n(n)/t}var Ys=new Map;function sg(i){return((""+i).split(".")[1]||"").length}function fa(i,e,t,n){let s=[],r=n.map(sg);for(let o=e;o<t;o++){let a=bn(o),l=kt(jr(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=i==10?h:kt(h,u);s.push(d),Ys.set(d,u)}}return s}var da={},td=[],Qr=[null,null],$s=Array.isArray,rg=Number.isInteger,h_=i=>i===void 0;function Rm(i){return typeof i=="string"}function wl(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function u_(i){return i!=null&&typeof i=="object"}var d_=Object.getPrototypeOf(Uint8Array),og="__proto__";function eo(i,e=wl){let t;if($s(i)){let n=i.find(s=>s!=null);if($s(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=eo(i[s],e)}else t=i.slice()}else if(i instanceof d_)t=i.slice();else if(e(i)){t={};for(let n in i)n!=og&&(t[n]=eo(i[n],e))}else t=i;return t}function pn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=og&&(wl(i[s])?pn(i[s],eo(n[s])):i[s]=eo(n[s]))}return i}var f_=0,p_=1,m_=2;function g_(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function y_(i,e){if(__(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return b_(o[0])||(o=x_(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),d=e?e[o][c]:p_,m=[];for(let g=0;g<h.length;g++){let y=h[g],p=r.get(l[g]);y===null?d!=f_&&(u[p]=y,d==m_&&m.push(p)):u[p]=y}g_(u,m,s),n.push(u)}}return n}var v_=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function x_(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function __(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function b_(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Kn(1,hi((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var ag=["January","February","March","April","May","June","July","August","September","October","November","December"],lg=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function cg(i){return i.slice(0,3)}var M_=lg.map(cg),S_=ag.map(cg),w_={MMMM:ag,MMM:S_,WWWW:lg,WWW:M_};function aa(i){return(i<10?"0":"")+i}function E_(i){return(i<10?"00":i<100?"0":"")+i}var T_={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>aa(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>aa(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>aa(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>aa(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>aa(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>E_(i.getMilliseconds())};function nd(i,e){e=e||w_;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?T_[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var A_=new Intl.DateTimeFormat().resolvedOptions().timeZone;function C_(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==A_?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var hg=i=>i%1==0,_l=[1,2,2.5,5],R_=fa(10,-32,0,_l),ug=fa(10,0,32,_l),P_=ug.filter(hg),xr=R_.concat(ug),id=`
`,dg="{YYYY}",Pm=id+dg,fg="{M}/{D}",ha=id+fg,ml=ha+"/{YY}",pg="{aa}",I_="{h}:{mm}",Zr=I_+pg,Im=id+Zr,Lm=":{ss}",Rt=null;function mg(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?fa(10,0,3,_l).filter(hg):fa(10,-3,0,_l)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,dg,Rt,Rt,Rt,Rt,Rt,Rt,1],[s*28,"{MMM}",Pm,Rt,Rt,Rt,Rt,Rt,1],[s,fg,Pm,Rt,Rt,Rt,Rt,Rt,1],[n,"{h}"+pg,ml,Rt,ha,Rt,Rt,Rt,1],[t,Zr,ml,Rt,ha,Rt,Rt,Rt,1],[e,Lm,ml+" "+Zr,Rt,ha+" "+Zr,Rt,Im,Rt,1],[i,Lm+".{fff}",ml+" "+Zr,Rt,ha+" "+Zr,Rt,Im,Rt,1]];function h(u){return(d,m,g,y,p,f)=>{let v=[],M=p>=o,b=p>=r&&p<o,E=u(g),T=kt(E*i,3),x=Fu(E.getFullYear(),M?0:E.getMonth(),b||M?1:E.getDate()),w=kt(x*i,3);if(b||M){let F=b?p/r:0,N=M?p/o:0,R=T==w?T:kt(Fu(x.getFullYear()+N,x.getMonth()+F,1)*i,3),U=new Date(_n(R/i)),k=U.getFullYear(),I=U.getMonth();for(let H=0;R<=y;H++){let Y=Fu(k+N*H,I+F*H,1),W=Y-u(kt(Y*i,3));R=kt((+Y+W)*i,3),R<=y&&v.push(R)}}else{let F=p>=s?s:p,N=hi(g)-hi(T),R=w+N+Sl(T-w,F);v.push(R);let U=u(R),k=U.getHours()+U.getMinutes()/t+U.getSeconds()/n,I=p/n,H=d.axes[m]._space,Y=f/H;for(;R=kt(R+p,i==1?0:3),!(R>y);)if(I>1){let W=hi(kt(k+I,6))%24,q=u(R).getHours()-W;q>1&&(q=-1),R-=q*n,k=(k+I)%24;let te=v[v.length-1];kt((R-te)/p,3)*Y>=.7&&v.push(R)}else v.push(R)}return v}}return[l,c,h]}var[L_,N_,D_]=mg(1),[U_,F_,O_]=mg(.001);fa(2,-53,53,[1]);function Nm(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function Dm(i,e){return(t,n,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,h,u,d,m;return n.map(g=>{let y=i(g),p=y.getFullYear(),f=y.getMonth(),v=y.getDate(),M=y.getHours(),b=y.getMinutes(),E=y.getSeconds(),T=p!=l&&a[2]||f!=c&&a[3]||v!=h&&a[4]||M!=u&&a[5]||b!=d&&a[6]||E!=m&&a[7]||a[1];return l=p,c=f,h=v,u=M,d=b,m=E,T(y)})}}function k_(i,e){let t=nd(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function Fu(i,e,t){return new Date(i,e,t)}function Um(i,e){return e(i)}var B_="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Fm(i,e){return(t,n,s,r)=>r==null?Zu:e(i(n))}function z_(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function V_(i,e){return i.series[e].fill(i,e)}var G_={show:!0,live:!0,isolate:!1,mount:a_,markers:{show:!0,width:2,stroke:z_,fill:V_,dash:"solid"},idx:null,idxs:null,values:[]};function H_(i,e){let t=i.cursor.points,n=Si(),s=t.size(i,e);Xt(n,la,s),Xt(n,ca,s);let r=s/-2;Xt(n,"marginLeft",r),Xt(n,"marginTop",r);let o=t.width(i,e,s);return o&&Xt(n,"borderWidth",o),n}function W_(i,e){let t=i.series[e].points;return t._fill||t._stroke}function X_(i,e){let t=i.series[e].points;return t._stroke||t._fill}function q_(i,e){return i.series[e].points.size}var Ou=[0,0];function $_(i,e,t){return Ou[0]=e,Ou[1]=t,Ou}function gl(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function ku(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var Y_={show:!0,x:!0,y:!0,lock:!1,move:$_,points:{one:!1,show:H_,size:q_,width:0,stroke:X_,fill:W_},bind:{mousedown:gl,mouseup:gl,click:gl,dblclick:gl,mousemove:ku,mouseleave:ku,mouseenter:ku},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},gg={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},sd=pn({},gg,{filter:ng}),yg=pn({},sd,{size:10}),vg=pn({},gg,{show:!1}),rd='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',xg="bold "+rd,_g=1.5,Om={show:!0,scale:"x",stroke:Ju,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:xg,side:2,grid:sd,ticks:yg,border:vg,font:rd,lineGap:_g,rotate:0},J_="Value",Z_="Time",km={show:!0,scale:"x",auto:!1,sorted:1,min:Ot,max:-Ot,idxs:[]};function K_(i,e,t,n,s){return e.map(r=>r==null?"":ed(r))}function j_(i,e,t,n,s,r,o){let a=[],l=Ys.get(s)||0;t=o?t:kt(Sl(t,s),l);for(let c=t;c<=n;c=kt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Wu(i,e,t,n,s,r,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?ys:Qm,h=hi(c(t));s=jr(l,h),l==10&&(s=xr[Ni(s,xr)]);let u=t,d=s*l;l==10&&(d=xr[Ni(d,xr)]);do a.push(u),u=u+s,l==10&&!Ys.has(u)&&(u=kt(u,Ys.get(s))),u>=d&&(s=u,d=s*l,l==10&&(d=xr[Ni(d,xr)]));while(u<=n);return a}function Q_(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?Wu(i,e,Kn(l,t),n,s):[l],h=n>=0&&t<=0?[0]:[];return(t<-l?Wu(i,e,Kn(l,-n),-t,s):[l]).reverse().map(d=>-d).concat(h,c)}var bg=/./,eb=/[12357]/,tb=/[125]/,Bm=/1/,Xu=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function nb(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?bg:l(7,o)-h>=c?eb:l(5,o)-h>=c?tb:Bm;if(u==Bm){let d=bn(l(1,o)-h);if(d<c)return Xu(e.slice().reverse(),a.distr,u,wi(c/d)).reverse()}return Xu(e,a.distr,u,1)}function ib(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=bn(l(1,o)-l(2,o));return c<a?Xu(e.slice().reverse(),3,bg,wi(a/c)).reverse():e}function sb(i,e,t,n){return n==null?Zu:e==null?"":ed(e)}var zm={show:!0,scale:"y",stroke:Ju,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:xg,side:3,grid:sd,ticks:yg,border:vg,font:rd,lineGap:_g,rotate:0};function rb(i,e){let t=3+(i||1)*2;return kt(t*e,3)}function ob(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=bn(o-r),l=i.series[e],c=a/(l.points.space*Ct);return n[1]-n[0]<=c}var Vm={scale:null,auto:!0,sorted:0,min:Ot,max:-Ot},Mg=(i,e,t,n,s)=>s,Gm={show:!0,auto:!0,sorted:0,gaps:Mg,alpha:1,facets:[pn({},Vm,{scale:"x"}),pn({},Vm,{scale:"y"})]},Hm={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Mg,alpha:1,points:{show:ob,filter:null},values:null,min:Ot,max:-Ot,idxs:[],path:null,clip:null};function ab(i,e,t,n,s){return t/10}var Sg={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},lb=pn({},Sg,{time:!1,ori:1}),Wm={};function wg(i,e){let t=Wm[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=s&&t.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(Wm[i]=t)),t}var to=1,qu=2;function Sr(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[e],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],d=a.left,m=a.top,g=a.width,y=a.height,p=i.valToPosH,f=i.valToPosV;return h.ori==0?t(s,l,c,h,u,p,f,d,m,g,y,Tl,io,Cl,Tg,Cg):t(s,l,c,h,u,f,p,m,d,y,g,Al,so,ld,Ag,Rg)}function od(i,e){let t=0,n=0,s=Tt(i.bands,td);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function cb(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function vs(i,e,t,n,s,r){return Sr(i,e,(o,a,l,c,h,u,d,m,g,y,p)=>{let f=o.pxRound,v=c.dir*(c.ori==0?1:-1),M=c.ori==0?io:so,b,E;v==1?(b=t,E=n):(b=n,E=t);let T=f(u(a[b],c,y,m)),x=f(d(l[b],h,p,g)),w=f(u(a[E],c,y,m)),F=f(d(r==1?h.max:h.min,h,p,g)),N=new Path2D(s);return M(N,w,F),M(N,T,F),M(N,T,x),N})}function El(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?Cl:ld,l=t;for(let u=0;u<i.length;u++){let d=i[u];if(d[1]>d[0]){let m=d[0]-l;m>0&&a(o,l,n,m,n+r),l=d[1]}}let c=t+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function hb(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function ad(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let u=c,d=c;if(s==1)for(;++c<=n&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let m=r(i[u]),g=d==u?m:r(i[d]),y=u-s;m=o<=0&&y>=0&&y<l?r(i[y]):m;let f=d+s;g=o>=0&&f>=0&&f<l?r(i[f]):g,g>=m&&a.push([m,g])}return a}function Xm(i){return i==0?tg:i==1?_n:e=>vr(e,i)}function Eg(i){let e=i==0?Tl:Al,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=Di(c,a/2,l/2),h=Di(h,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,h),t(s,r,o+l,r,o,h),t(s,r,o,r+a,o,c),s.closePath())}}var Tl=(i,e,t)=>{i.moveTo(e,t)},Al=(i,e,t)=>{i.moveTo(t,e)},io=(i,e,t)=>{i.lineTo(e,t)},so=(i,e,t)=>{i.lineTo(t,e)},Cl=Eg(0),ld=Eg(1),Tg=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},Ag=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},Cg=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},Rg=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function Pg(i){return(e,t,n,s,r)=>Sr(e,t,(o,a,l,c,h,u,d,m,g,y,p)=>{let{pxRound:f,points:v}=o,M,b;c.ori==0?(M=Tl,b=Tg):(M=Al,b=Ag);let E=kt(v.width*Ct,3),T=(v.size-v.width)/2*Ct,x=kt(T*2,3),w=new Path2D,F=new Path2D,{left:N,top:R,width:U,height:k}=e.bbox;Cl(F,N-x,R-x,U+x*2,k+x*2);let I=H=>{if(l[H]!=null){let Y=f(u(a[H],c,y,m)),W=f(d(l[H],h,p,g));M(w,Y+T,W),b(w,Y,W,T,0,yl*2)}};if(r)r.forEach(I);else for(let H=n;H<=s;H++)I(H);return{stroke:E>0?w:null,fill:w,clip:F,flags:to|qu}})}function Ig(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var ub=Ig(io),db=Ig(so);function Lg(i){let e=Tt(i?.alignGaps,0);return(t,n,s,r)=>Sr(t,n,(o,a,l,c,h,u,d,m,g,y,p)=>{[s,r]=bl(l,s,r);let f=o.pxRound,v=k=>f(u(k,c,y,m)),M=k=>f(d(k,h,p,g)),b,E;c.ori==0?(b=io,E=ub):(b=so,E=db);let T=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:to},w=x.stroke,F=!1;if(r-s>=y*4){let k=he=>t.posToVal(he,c.key,!0),I=null,H=null,Y,W,le,Z=v(a[T==1?s:r]),q=v(a[s]),te=v(a[r]),ce=k(T==1?q+1:te-1);for(let he=T==1?s:r;he>=s&&he<=r;he+=T){let Q=a[he],ge=(T==1?Q<ce:Q>ce)?Z:v(Q),Ae=l[he];ge==Z?Ae!=null?(W=Ae,I==null?(b(w,ge,M(W)),Y=I=H=W):W<I?I=W:W>H&&(H=W)):Ae===null&&(F=!0):(I!=null&&E(w,Z,M(I),M(H),M(Y),M(W)),Ae!=null?(W=Ae,b(w,ge,M(W)),I=H=Y=W):(I=H=null,Ae===null&&(F=!0)),Z=ge,ce=k(Z+T))}I!=null&&I!=H&&le!=Z&&E(w,Z,M(I),M(H),M(Y),M(W))}else for(let k=T==1?s:r;k>=s&&k<=r;k+=T){let I=l[k];I===null?F=!0:I!=null&&b(w,v(a[k]),M(I))}let[R,U]=od(t,n);if(o.fill!=null||R!=0){let k=x.fill=new Path2D(w),I=o.fillTo(t,n,o.min,o.max,R),H=M(I),Y=v(a[s]),W=v(a[r]);T==-1&&([W,Y]=[Y,W]),b(k,W,H),b(k,Y,H)}if(!o.spanGaps){let k=[];F&&k.push(...ad(a,l,s,r,T,v,e)),x.gaps=k=o.gaps(t,n,s,r,k),x.clip=El(k,c.ori,m,g,y,p)}return U!=0&&(x.band=U==2?[vs(t,n,s,r,w,-1),vs(t,n,s,r,w,1)]:vs(t,n,s,r,w,U)),x})}function fb(i){let e=Tt(i.align,1),t=Tt(i.ascDesc,!1),n=Tt(i.alignGaps,0),s=Tt(i.extend,!1);return(r,o,a,l)=>Sr(r,o,(c,h,u,d,m,g,y,p,f,v,M)=>{[a,l]=bl(u,a,l);let b=c.pxRound,{left:E,width:T}=r.bbox,x=q=>b(g(q,d,v,p)),w=q=>b(y(q,m,M,f)),F=d.ori==0?io:so,N={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:to},R=N.stroke,U=d.dir*(d.ori==0?1:-1),k=w(u[U==1?a:l]),I=x(h[U==1?a:l]),H=I,Y=I;s&&e==-1&&(Y=E,F(R,Y,k)),F(R,I,k);for(let q=U==1?a:l;q>=a&&q<=l;q+=U){let te=u[q];if(te==null)continue;let ce=x(h[q]),he=w(te);e==1?F(R,ce,k):F(R,H,he),F(R,ce,he),k=he,H=ce}let W=H;s&&e==1&&(W=E+T,F(R,W,k));let[le,Z]=od(r,o);if(c.fill!=null||le!=0){let q=N.fill=new Path2D(R),te=c.fillTo(r,o,c.min,c.max,le),ce=w(te);F(q,W,ce),F(q,Y,ce)}if(!c.spanGaps){let q=[];q.push(...ad(h,u,a,l,U,x,n));let te=c.width*Ct/2,ce=t||e==1?te:-te,he=t||e==-1?-te:te;q.forEach(Q=>{Q[0]+=ce,Q[1]+=he}),N.gaps=q=c.gaps(r,o,a,l,q),N.clip=El(q,d.ori,p,f,v,M)}return Z!=0&&(N.band=Z==2?[vs(r,o,a,l,R,-1),vs(r,o,a,l,R,1)]:vs(r,o,a,l,R,Z)),N})}function qm(i,e,t,n,s,r,o=Ot){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let h=bn(i[l]-i[a]);h<c&&(c=h,o=bn(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function pb(i){i=i||da;let e=Tt(i.size,[.6,Ot,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=yt(s),o=1-e[0],a=Tt(e[1],Ot),l=Tt(e[2],1),c=Tt(i.disp,da),h=Tt(i.each,m=>{}),{fill:u,stroke:d}=c;return(m,g,y,p)=>Sr(m,g,(f,v,M,b,E,T,x,w,F,N,R)=>{let U=f.pxRound,k=t,I=n*Ct,H=a*Ct,Y=l*Ct,W,le;b.ori==0?[W,le]=r(m,g):[le,W]=r(m,g);let Z=b.dir*(b.ori==0?1:-1),q=b.ori==0?Cl:ld,te=b.ori==0?h:(Re,Je,ot,Se,Ft,Ve,Ye)=>{h(Re,Je,ot,Ft,Se,Ye,Ve)},ce=Tt(m.bands,td).find(Re=>Re.series[0]==g),he=ce!=null?ce.dir:0,Q=f.fillTo(m,g,f.min,f.max,he),me=U(x(Q,E,R,F)),ge,Ae,Me,Xe=N,rt=U(f.width*Ct),He=!1,ut=null,lt=null,it=null,$t=null;u!=null&&(rt==0||d!=null)&&(He=!0,ut=u.values(m,g,y,p),lt=new Map,new Set(ut).forEach(Re=>{Re!=null&&lt.set(Re,new Path2D)}),rt>0&&(it=d.values(m,g,y,p),$t=new Map,new Set(it).forEach(Re=>{Re!=null&&$t.set(Re,new Path2D)})));let{x0:Bt,size:ln}=c;if(Bt!=null&&ln!=null){k=1,v=Bt.values(m,g,y,p),Bt.unit==2&&(v=v.map(ot=>m.posToVal(w+ot*N,b.key,!0)));let Re=ln.values(m,g,y,p);ln.unit==2?Ae=Re[0]*N:Ae=T(Re[0],b,N,w)-T(0,b,N,w),Xe=qm(v,M,T,b,N,w,Xe),Me=Xe-Ae+I}else Xe=qm(v,M,T,b,N,w,Xe),Me=Xe*o+I,Ae=Xe-Me;Me<1&&(Me=0),rt>=Ae/2&&(rt=0),Me<5&&(U=tg);let Dt=Me>0,wn=Xe-Me-(Dt?rt:0);Ae=U(Hu(wn,Y,H)),ge=(k==0?Ae/2:k==Z?0:Ae)-k*Z*((k==0?I/2:0)+(Dt?rt/2:0));let Mt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},gn=He?null:new Path2D,en=null;if(ce!=null)en=m.data[ce.series[1]];else{let{y0:Re,y1:Je}=c;Re!=null&&Je!=null&&(M=Je.values(m,g,y,p),en=Re.values(m,g,y,p))}let cn=W*Ae,z=le*Ae;for(let Re=Z==1?y:p;Re>=y&&Re<=p;Re+=Z){let Je=M[Re];if(Je==null)continue;if(en!=null){let $=en[Re]??0;if(Je-$==0)continue;me=x($,E,R,F)}let ot=b.distr!=2||c!=null?v[Re]:Re,Se=T(ot,b,N,w),Ft=x(Tt(Je,Q),E,R,F),Ve=U(Se-ge),Ye=U(Kn(Ft,me)),P=U(Di(Ft,me)),S=Ye-P;if(Je!=null){let $=Je<0?z:cn,de=Je<0?cn:z;He?(rt>0&&it[Re]!=null&&q($t.get(it[Re]),Ve,P+hi(rt/2),Ae,Kn(0,S-rt),$,de),ut[Re]!=null&&q(lt.get(ut[Re]),Ve,P+hi(rt/2),Ae,Kn(0,S-rt),$,de)):q(gn,Ve,P+hi(rt/2),Ae,Kn(0,S-rt),$,de),te(m,g,Re,Ve-rt/2,P,Ae+rt,S)}}return rt>0?Mt.stroke=He?$t:gn:He||(Mt._fill=f.width==0?f._fill:f._stroke??f._fill,Mt.width=0),Mt.fill=He?lt:gn,Mt})}function mb(i,e){let t=Tt(e?.alignGaps,0);return(n,s,r,o)=>Sr(n,s,(a,l,c,h,u,d,m,g,y,p,f)=>{[r,o]=bl(c,r,o);let v=a.pxRound,M=W=>v(d(W,h,p,g)),b=W=>v(m(W,u,f,y)),E,T,x;h.ori==0?(E=Tl,x=io,T=Cg):(E=Al,x=so,T=Rg);let w=h.dir*(h.ori==0?1:-1),F=M(l[w==1?r:o]),N=F,R=[],U=[];for(let W=w==1?r:o;W>=r&&W<=o;W+=w)if(c[W]!=null){let Z=l[W],q=M(Z);R.push(N=q),U.push(b(c[W]))}let k={stroke:i(R,U,E,x,T,v),fill:null,clip:null,band:null,gaps:null,flags:to},I=k.stroke,[H,Y]=od(n,s);if(a.fill!=null||H!=0){let W=k.fill=new Path2D(I),le=a.fillTo(n,s,a.min,a.max,H),Z=b(le);x(W,N,Z),x(W,F,Z)}if(!a.spanGaps){let W=[];W.push(...ad(l,c,r,o,w,M,t)),k.gaps=W=a.gaps(n,s,r,o,W),k.clip=El(W,h.ori,g,y,p,f)}return Y!=0&&(k.band=Y==2?[vs(n,s,r,o,I,-1),vs(n,s,r,o,I,1)]:vs(n,s,r,o,I,Y)),k})}function gb(i){return mb(yb,i)}function yb(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let d=0;d<o-1;d++)h[d]=e[d+1]-e[d],u[d]=i[d+1]-i[d],c[d]=h[d]/u[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/c[d-1]+(u[d]+2*u[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,i[d]+u[d]/3,e[d]+l[d]*u[d]/3,i[d+1]-u[d]/3,e[d+1]-l[d+1]*u[d]/3,i[d+1],e[d+1])}return a}var $u=new Set;function $m(){for(let i of $u)i.syncRect(!0)}no&&(br(Kx,Kr,$m),br(jx,Kr,$m,!0),br(vl,Kr,()=>{Nn.pxRatio=Ct}));var vb=Lg(),xb=Pg();function Ym(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Yu(r,o,e,t))}function _b(i,e){return i.map((t,n)=>n==0?{}:pn({},e,t))}function Yu(i,e,t,n){return pn({},e==0?t:n,i)}function Ng(i,e,t){return e==null?Qr:[e,t]}var bb=Ng;function Mb(i,e,t){return e==null?Qr:xl(e,t,Qu,!0)}function Dg(i,e,t,n){return e==null?Qr:Ml(e,t,i.scales[n].log,!1)}var Sb=Dg;function Ug(i,e,t,n){return e==null?Qr:ju(e,t,i.scales[n].log,!1)}var wb=Ug;function Eb(i,e,t,n,s){let r=Kn(Tm(i),Tm(e)),o=e-i,a=Ni(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?Ys.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function Jm(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=_n((t=+s)*Ct))+"px"),[i,e,t]}function Tb(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=kt(e[2]*Ct,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Nn(i,e,t){let n={mode:Tt(i.mode,1)},s=n.mode;function r(_,A,L,D){let X=A.valToPct(_);return D+L*(A.dir==-1?1-X:X)}function o(_,A,L,D){let X=A.valToPct(_);return D+L*(A.dir==-1?X:1-X)}function a(_,A,L,D){return A.ori==0?r(_,A,L,D):o(_,A,L,D)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=Si(Nx);if(i.id!=null&&(c.id=i.id),ci(c,i.class),i.title){let _=Si(Fx,c);_.textContent=i.title}let h=Li("canvas"),u=n.ctx=h.getContext("2d"),d=Si(Ox,c);br("click",d,_=>{_.target===g&&(Gt!=Vr||Yt!=Gr)&&Ln.click(n,_)},!0);let m=n.under=Si(kx,d);d.appendChild(h);let g=n.over=Si(Bx,d);i=eo(i);let y=+Tt(i.pxAlign,1),p=Xm(y);(i.plugins||[]).forEach(_=>{_.opts&&(i=_.opts(n,i)||i)});let f=i.ms||.001,v=n.series=s==1?Ym(i.series||[],km,Hm,!1):_b(i.series||[null],Gm),M=n.axes=Ym(i.axes||[],Om,zm,!0),b=n.scales={},E=n.bands=i.bands||[];E.forEach(_=>{_.fill=yt(_.fill||null),_.dir=Tt(_.dir,-1)});let T=s==2?v[1].facets[0].scale:v[0].scale,x={axes:ms,series:pt},w=(i.drawOrder||["axes","series"]).map(_=>x[_]);function F(_){let A=_.distr==3?L=>ys(L>0?L:_.clamp(n,L,_.min,_.max,_.key)):_.distr==4?L=>Uu(L,_.asinh):_.distr==100?L=>_.fwd(L):L=>L;return L=>{let D=A(L),{_min:X,_max:j}=_,ae=j-X;return(D-X)/ae}}function N(_){let A=b[_];if(A==null){let L=(i.scales||da)[_]||da;if(L.from!=null){N(L.from);let D=pn({},b[L.from],L,{key:_});D.valToPct=F(D),b[_]=D}else{A=b[_]=pn({},_==T?Sg:lb,L),A.key=_;let D=A.time,X=A.range,j=$s(X);if((_!=T||s==2&&!D)&&(j&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?Sm:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?Sm:{mode:1,hard:X[1],soft:X[1]}},j=!1),!j&&wl(X))){let ae=X;X=(fe,_e,De)=>_e==null?Qr:xl(_e,De,ae)}A.range=yt(X||(D?bb:_==T?A.distr==3?Sb:A.distr==4?wb:Ng:A.distr==3?Dg:A.distr==4?Ug:Mb)),A.auto=yt(j?!1:A.auto),A.clamp=yt(A.clamp||ab),A._min=A._max=null,A.valToPct=F(A)}}}N("x"),N("y"),s==1&&v.forEach(_=>{N(_.scale)}),M.forEach(_=>{N(_.scale)});for(let _ in i.scales)N(_);let R=b[T],U=R.distr,k,I;R.ori==0?(ci(c,Dx),k=r,I=o):(ci(c,Ux),k=o,I=r);let H={};for(let _ in b){let A=b[_];(A.min!=null||A.max!=null)&&(H[_]={min:A.min,max:A.max},A.min=A.max=null)}let Y=i.tzDate||(_=>new Date(_n(_/f))),W=i.fmtDate||nd,le=f==1?D_(Y):O_(Y),Z=Dm(Y,Nm(f==1?N_:F_,W)),q=Fm(Y,Um(B_,W)),te=[],ce=n.legend=pn({},G_,i.legend),he=n.cursor=pn({},Y_,{drag:{y:s==2}},i.cursor),Q=ce.show,me=he.show,ge=ce.markers;ce.idxs=te,ge.width=yt(ge.width),ge.dash=yt(ge.dash),ge.stroke=yt(ge.stroke),ge.fill=yt(ge.fill);let Ae,Me,Xe,rt=[],He=[],ut,lt=!1,it={};if(ce.live){let _=v[1]?v[1].values:null;lt=_!=null,ut=lt?_(n,1,0):{_:0};for(let A in ut)it[A]=Zu}if(Q)if(Ae=Li("table",Xx,c),Xe=Li("tbody",null,Ae),ce.mount(n,Ae),lt){Me=Li("thead",null,Ae,Xe);let _=Li("tr",null,Me);Li("th",null,_);for(var $t in ut)Li("th",hm,_).textContent=$t}else ci(Ae,$x),ce.live&&ci(Ae,qx);let Bt={show:!0},ln={show:!1};function Dt(_,A){if(A==0&&(lt||!ce.live||s==2))return Qr;let L=[],D=Li("tr",Yx,Xe,Xe.childNodes[A]);ci(D,_.class),_.show||ci(D,_r);let X=Li("th",null,D);if(ge.show){let fe=Si(Jx,X);if(A>0){let _e=ge.width(n,A);_e&&(fe.style.border=_e+"px "+ge.dash(n,A)+" "+ge.stroke(n,A)),fe.style.background=ge.fill(n,A)}}let j=Si(hm,X);_.label instanceof HTMLElement?j.appendChild(_.label):j.textContent=_.label,A>0&&(ge.show||(j.style.color=_.width>0?ge.stroke(n,A):ge.fill(n,A)),Mt("click",X,fe=>{if(he._lock)return;je(fe);let _e=v.indexOf(_);if((fe.ctrlKey||fe.metaKey)!=ce.isolate){let De=v.some((Ue,Oe)=>Oe>0&&Oe!=_e&&Ue.show);v.forEach((Ue,Oe)=>{Oe>0&&Yi(Oe,De?Oe==_e?Bt:ln:Bt,!0,fn.setSeries)})}else Yi(_e,{show:!_.show},!0,fn.setSeries)},!1),Qe&&Mt(pm,X,fe=>{he._lock||(je(fe),Yi(v.indexOf(_),Wr,!0,fn.setSeries))},!1));for(var ae in ut){let fe=Li("td",Zx,D);fe.textContent="--",L.push(fe)}return[D,L]}let wn=new Map;function Mt(_,A,L,D=!0){let X=wn.get(A)||{},j=he.bind[_](n,A,L,D);j&&(br(_,A,X[_]=j),wn.set(A,X))}function gn(_,A,L){let D=wn.get(A)||{};for(let X in D)(_==null||X==_)&&(Gu(X,A,D[X]),delete D[X]);_==null&&wn.delete(A)}let en=0,cn=0,z=0,Re=0,Je=0,ot=0,Se=Je,Ft=ot,Ve=z,Ye=Re,P=0,S=0,$=0,de=0;n.bbox={};let oe=!1,ve=!1,xe=!1,ne=!1,se=!1,pe=!1;function B(_,A,L){(L||_!=n.width||A!=n.height)&&re(_,A),ct(!1),xe=!0,ve=!0,Fn()}function re(_,A){n.width=en=z=_,n.height=cn=Re=A,Je=ot=0,be(),We();let L=n.bbox;P=L.left=vr(Je*Ct,.5),S=L.top=vr(ot*Ct,.5),$=L.width=vr(z*Ct,.5),de=L.height=vr(Re*Ct,.5)}let ie=3;function we(){let _=!1,A=0;for(;!_;){A++;let L=kr(A),D=$i(A);_=A==ie||L&&D,_||(re(n.width,n.height),ve=!0)}}function ye({width:_,height:A}){B(_,A)}n.setSize=ye;function be(){let _=!1,A=!1,L=!1,D=!1;M.forEach((X,j)=>{if(X.show&&X._show){let{side:ae,_size:fe}=X,_e=ae%2,De=X.label!=null?X.labelSize:0,Ue=fe+De;Ue>0&&(_e?(z-=Ue,ae==3?(Je+=Ue,D=!0):L=!0):(Re-=Ue,ae==0?(ot+=Ue,_=!0):A=!0))}}),Xi[0]=_,Xi[1]=L,Xi[2]=A,Xi[3]=D,z-=Ci[1]+Ci[3],Je+=Ci[3],Re-=Ci[2]+Ci[0],ot+=Ci[0]}function We(){let _=Je+z,A=ot+Re,L=Je,D=ot;function X(j,ae){switch(j){case 1:return _+=ae,_-ae;case 2:return A+=ae,A-ae;case 3:return L-=ae,L+ae;case 0:return D-=ae,D+ae}}M.forEach((j,ae)=>{if(j.show&&j._show){let fe=j.side;j._pos=X(fe,j._size),j.label!=null&&(j._lpos=X(fe,j.labelSize))}})}if(he.dataIdx==null){let _=he.hover,A=_.skip=new Set(_.skip??[]);A.add(void 0);let L=_.prox=yt(_.prox),D=_.bias??=0;he.dataIdx=(X,j,ae,fe)=>{if(j==0)return ae;let _e=ae,De=L(X,j,ae,fe)??Ot,Ue=De>=0&&De<Ot,Oe=R.ori==0?z:Re,st=he.left,At=e[0],St=e[j];if(A.has(St[ae])){_e=null;let mt=null,Ke=null,qe;if(D==0||D==-1)for(qe=ae;mt==null&&qe-- >0;)A.has(St[qe])||(mt=qe);if(D==0||D==1)for(qe=ae;Ke==null&&qe++<St.length;)A.has(St[qe])||(Ke=qe);if(mt!=null||Ke!=null)if(Ue){let Wt=mt==null?-1/0:k(At[mt],R,Oe,0),sn=Ke==null?1/0:k(At[Ke],R,Oe,0),Cn=st-Wt,Ut=sn-st;Cn<=Ut?Cn<=De&&(_e=mt):Ut<=De&&(_e=Ke)}else _e=Ke==null?mt:mt==null?Ke:ae-mt<=Ke-ae?mt:Ke}else Ue&&bn(st-k(At[ae],R,Oe,0))>De&&(_e=null);return _e}}let je=_=>{he.event=_};he.idxs=te,he._lock=!1;let ue=he.points;ue.show=yt(ue.show),ue.size=yt(ue.size),ue.stroke=yt(ue.stroke),ue.width=yt(ue.width),ue.fill=yt(ue.fill);let ke=n.focus=pn({},i.focus||{alpha:.3},he.focus),Qe=ke.prox>=0,Ce=Qe&&ue.one,at=[],Vt=[],Wn=[];function Jo(_,A){let L=ue.show(n,A);if(L instanceof HTMLElement)return ci(L,Wx),ci(L,_.class),is(L,-10,-10,z,Re),g.insertBefore(L,at[A]),L}function Ur(_,A){if(s==1||A>0){let L=s==1&&b[_.scale].time,D=_.value;_.value=L?Rm(D)?Fm(Y,Um(D,W)):D||q:D||sb,_.label=_.label||(L?Z_:J_)}if(Ce||A>0){_.width=_.width==null?1:_.width,_.paths=_.paths||vb||l_,_.fillTo=yt(_.fillTo||cb),_.pxAlign=+Tt(_.pxAlign,y),_.pxRound=Xm(_.pxAlign),_.stroke=yt(_.stroke||null),_.fill=yt(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let L=rb(Kn(1,_.width),1),D=_.points=pn({},{size:L,width:Kn(1,L*.2),stroke:_.stroke,space:L*2,paths:xb,_stroke:null,_fill:null},_.points);D.show=yt(D.show),D.filter=yt(D.filter),D.fill=yt(D.fill),D.stroke=yt(D.stroke),D.paths=yt(D.paths),D.pxAlign=_.pxAlign}if(Q){let L=Dt(_,A);rt.splice(A,0,L[0]),He.splice(A,0,L[1]),ce.values.push(null)}if(me){te.splice(A,0,null);let L=null;Ce?A==0&&(L=Jo(_,A)):A>0&&(L=Jo(_,A)),at.splice(A,0,L),Vt.splice(A,0,0),Wn.splice(A,0,0)}An("addSeries",A)}function ou(_,A){A=A??v.length,_=s==1?Yu(_,A,km,Hm):Yu(_,A,{},Gm),v.splice(A,0,_),Ur(v[A],A)}n.addSeries=ou;function ja(_){if(v.splice(_,1),Q){ce.values.splice(_,1),He.splice(_,1);let A=rt.splice(_,1)[0];gn(null,A.firstChild),A.remove()}me&&(te.splice(_,1),at.splice(_,1)[0].remove(),Vt.splice(_,1),Wn.splice(_,1)),An("delSeries",_)}n.delSeries=ja;let Xi=[!1,!1,!1,!1];function ds(_,A){if(_._show=_.show,_.show){let L=_.side%2,D=b[_.scale];D==null&&(_.scale=L?v[1].scale:T,D=b[_.scale]);let X=D.time;_.size=yt(_.size),_.space=yt(_.space),_.rotate=yt(_.rotate),$s(_.incrs)&&_.incrs.forEach(ae=>{!Ys.has(ae)&&Ys.set(ae,sg(ae))}),_.incrs=yt(_.incrs||(D.distr==2?P_:X?f==1?L_:U_:xr)),_.splits=yt(_.splits||(X&&D.distr==1?le:D.distr==3?Wu:D.distr==4?Q_:j_)),_.stroke=yt(_.stroke),_.grid.stroke=yt(_.grid.stroke),_.ticks.stroke=yt(_.ticks.stroke),_.border.stroke=yt(_.border.stroke);let j=_.values;_.values=$s(j)&&!$s(j[0])?yt(j):X?$s(j)?Dm(Y,Nm(j,W)):Rm(j)?k_(Y,j):j||Z:j||K_,_.filter=yt(_.filter||(D.distr>=3&&D.log==10?nb:D.distr==3&&D.log==2?ib:ng)),_.font=Jm(_.font),_.labelFont=Jm(_.labelFont),_._size=_.size(n,null,A,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(Xi[A]=!0,_._el=Si(zx,d))}}function fs(_,A,L,D){let[X,j,ae,fe]=L,_e=A%2,De=0;return _e==0&&(fe||j)&&(De=A==0&&!X||A==2&&!ae?_n(Om.size/3):0),_e==1&&(X||ae)&&(De=A==1&&!j||A==3&&!fe?_n(zm.size/2):0),De}let Zo=n.padding=(i.padding||[fs,fs,fs,fs]).map(_=>yt(Tt(_,fs))),Ci=n._padding=Zo.map((_,A)=>_(n,A,Xi,0)),tn,on=null,an=null,qi=s==1?v[0].idxs:null,si=null,Us=!1;function Ko(_,A){if(e=_??[],n.data=n._data=e,s==2){tn=0;for(let L=1;L<v.length;L++)tn+=e[L][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),si=e[0],tn=si.length;let L=e;if(U==2){L=e.slice();let D=L[0]=Array(tn);for(let X=0;X<tn;X++)D[X]=X}n._data=e=L}if(ct(!0),An("setData"),U==2&&(xe=!0),A!==!1){let L=R;L.auto(n,Us)?jo():ks(T,L.min,L.max),ne=ne||he.left>=0,pe=!0,Fn()}}n.setData=Ko;function jo(){Us=!0;let _,A;s==1&&(tn>0?(on=qi[0]=0,an=qi[1]=tn-1,_=e[0][on],A=e[0][an],U==2?(_=on,A=an):_==A&&(U==3?[_,A]=Ml(_,_,R.log,!1):U==4?[_,A]=ju(_,_,R.log,!1):R.time?A=_+_n(86400/f):[_,A]=xl(_,A,Qu,!0))):(on=qi[0]=_=null,an=qi[1]=A=null)),ks(T,_,A)}let Fr,Fs,Or,C,G,ee,J,K,Ee,Pe;function Te(_,A,L,D,X,j){_??=dm,L??=td,D??="butt",X??=dm,j??="round",_!=Fr&&(u.strokeStyle=Fr=_),X!=Fs&&(u.fillStyle=Fs=X),A!=Or&&(u.lineWidth=Or=A),j!=G&&(u.lineJoin=G=j),D!=ee&&(u.lineCap=ee=D),L!=C&&u.setLineDash(C=L)}function Ie(_,A,L,D){A!=Fs&&(u.fillStyle=Fs=A),_!=J&&(u.font=J=_),L!=K&&(u.textAlign=K=L),D!=Ee&&(u.textBaseline=Ee=D)}function ze(_,A,L,D,X=0){if(D.length>0&&_.auto(n,Us)&&(A==null||A.min==null)){let j=Tt(on,0),ae=Tt(an,D.length-1),fe=L.min==null?n_(D,j,ae,X,_.distr==3):[L.min,L.max];_.min=Di(_.min,L.min=fe[0]),_.max=Kn(_.max,L.max=fe[1])}}let et={min:null,max:null};function ft(){for(let D in b){let X=b[D];H[D]==null&&(X.min==null||H[T]!=null&&X.auto(n,Us))&&(H[D]=et)}for(let D in b){let X=b[D];H[D]==null&&X.from!=null&&H[X.from]!=null&&(H[D]=et)}H[T]!=null&&ct(!0);let _={};for(let D in H){let X=H[D];if(X!=null){let j=_[D]=eo(b[D],u_);if(X.min!=null)pn(j,X);else if(D!=T||s==2)if(tn==0&&j.from==null){let ae=j.range(n,null,null,D);j.min=ae[0],j.max=ae[1]}else j.min=Ot,j.max=-Ot}}if(tn>0){v.forEach((D,X)=>{if(s==1){let j=D.scale,ae=H[j];if(ae==null)return;let fe=_[j];if(X==0){let _e=fe.range(n,fe.min,fe.max,j);fe.min=_e[0],fe.max=_e[1],on=Ni(fe.min,e[0]),an=Ni(fe.max,e[0]),an-on>1&&(e[0][on]<fe.min&&on++,e[0][an]>fe.max&&an--),D.min=si[on],D.max=si[an]}else D.show&&D.auto&&ze(fe,ae,D,e[X],D.sorted);D.idxs[0]=on,D.idxs[1]=an}else if(X>0&&D.show&&D.auto){let[j,ae]=D.facets,fe=j.scale,_e=ae.scale,[De,Ue]=e[X],Oe=_[fe],st=_[_e];Oe!=null&&ze(Oe,H[fe],j,De,j.sorted),st!=null&&ze(st,H[_e],ae,Ue,ae.sorted),D.min=ae.min,D.max=ae.max}});for(let D in _){let X=_[D],j=H[D];if(X.from==null&&(j==null||j.min==null)){let ae=X.range(n,X.min==Ot?null:X.min,X.max==-Ot?null:X.max,D);X.min=ae[0],X.max=ae[1]}}}for(let D in _){let X=_[D];if(X.from!=null){let j=_[X.from];if(j.min==null)X.min=X.max=null;else{let ae=X.range(n,j.min,j.max,D);X.min=ae[0],X.max=ae[1]}}}let A={},L=!1;for(let D in _){let X=_[D],j=b[D];if(j.min!=X.min||j.max!=X.max){j.min=X.min,j.max=X.max;let ae=j.distr;j._min=ae==3?ys(j.min):ae==4?Uu(j.min,j.asinh):ae==100?j.fwd(j.min):j.min,j._max=ae==3?ys(j.max):ae==4?Uu(j.max,j.asinh):ae==100?j.fwd(j.max):j.max,A[D]=L=!0}}if(L){v.forEach((D,X)=>{s==2?X>0&&A.y&&(D._paths=null):A[D.scale]&&(D._paths=null)});for(let D in A)xe=!0,An("setScale",D);me&&he.left>=0&&(ne=pe=!0)}for(let D in H)H[D]=null}function Be(_){let A=Hu(on-1,0,tn-1),L=Hu(an+1,0,tn-1);for(;_[A]==null&&A>0;)A--;for(;_[L]==null&&L<tn-1;)L++;return[A,L]}function pt(){if(tn>0){let _=v.some(A=>A._focus)&&Pe!=ke.alpha;_&&(u.globalAlpha=Pe=ke.alpha),v.forEach((A,L)=>{if(L>0&&A.show&&(jt(L,!1),jt(L,!0),A._paths==null)){let D=Pe;Pe!=A.alpha&&(u.globalAlpha=Pe=A.alpha);let X=s==2?[0,e[L][0].length-1]:Be(e[L]);A._paths=A.paths(n,L,X[0],X[1]),Pe!=D&&(u.globalAlpha=Pe=D)}}),v.forEach((A,L)=>{if(L>0&&A.show){let D=Pe;Pe!=A.alpha&&(u.globalAlpha=Pe=A.alpha),A._paths!=null&&It(L,!1);{let X=A._paths!=null?A._paths.gaps:null,j=A.points.show(n,L,on,an,X),ae=A.points.filter(n,L,j,X);(j||ae)&&(A.points._paths=A.points.paths(n,L,on,an,ae),It(L,!0))}Pe!=D&&(u.globalAlpha=Pe=D),An("drawSeries",L)}}),_&&(u.globalAlpha=Pe=1)}}function jt(_,A){let L=A?v[_].points:v[_];L._stroke=L.stroke(n,_),L._fill=L.fill(n,_)}function It(_,A){let L=A?v[_].points:v[_],{stroke:D,fill:X,clip:j,flags:ae,_stroke:fe=L._stroke,_fill:_e=L._fill,_width:De=L.width}=L._paths;De=kt(De*Ct,3);let Ue=null,Oe=De%2/2;A&&_e==null&&(_e=De>0?"#fff":fe);let st=L.pxAlign==1&&Oe>0;if(st&&u.translate(Oe,Oe),!A){let At=P-De/2,St=S-De/2,mt=$+De,Ke=de+De;Ue=new Path2D,Ue.rect(At,St,mt,Ke)}A?Fe(fe,De,L.dash,L.cap,_e,D,X,ae,j):Lt(_,fe,De,L.dash,L.cap,_e,D,X,ae,Ue,j),st&&u.translate(-Oe,-Oe)}function Lt(_,A,L,D,X,j,ae,fe,_e,De,Ue){let Oe=!1;_e!=0&&E.forEach((st,At)=>{if(st.series[0]==_){let St=v[st.series[1]],mt=e[st.series[1]],Ke=(St._paths||da).band;$s(Ke)&&(Ke=st.dir==1?Ke[0]:Ke[1]);let qe,Wt=null;St.show&&Ke&&s_(mt,on,an)?(Wt=st.fill(n,At)||j,qe=St._paths.clip):Ke=null,Fe(A,L,D,X,Wt,ae,fe,_e,De,Ue,qe,Ke),Oe=!0}}),Oe||Fe(A,L,D,X,j,ae,fe,_e,De,Ue)}let yn=to|qu;function Fe(_,A,L,D,X,j,ae,fe,_e,De,Ue,Oe){Te(_,A,L,D,X),(_e||De||Oe)&&(u.save(),_e&&u.clip(_e),De&&u.clip(De)),Oe?(fe&yn)==yn?(u.clip(Oe),Ue&&u.clip(Ue),gt(X,ae),hn(_,j,A)):fe&qu?(gt(X,ae),u.clip(Oe),hn(_,j,A)):fe&to&&(u.save(),u.clip(Oe),Ue&&u.clip(Ue),gt(X,ae),u.restore(),hn(_,j,A)):(gt(X,ae),hn(_,j,A)),(_e||De||Oe)&&u.restore()}function hn(_,A,L){L>0&&(A instanceof Map?A.forEach((D,X)=>{u.strokeStyle=Fr=X,u.stroke(D)}):A!=null&&_&&u.stroke(A))}function gt(_,A){A instanceof Map?A.forEach((L,D)=>{u.fillStyle=Fs=D,u.fill(L)}):A!=null&&_&&u.fill(A)}function ps(_,A,L,D){let X=M[_],j;if(D<=0)j=[0,0];else{let ae=X._space=X.space(n,_,A,L,D),fe=X._incrs=X.incrs(n,_,A,L,D,ae);j=Eb(A,L,fe,D,ae)}return X._found=j}function un(_,A,L,D,X,j,ae,fe,_e,De){let Ue=ae%2/2;y==1&&u.translate(Ue,Ue),Te(fe,ae,_e,De,fe),u.beginPath();let Oe,st,At,St,mt=X+(D==0||D==3?-j:j);L==0?(st=X,St=mt):(Oe=X,At=mt);for(let Ke=0;Ke<_.length;Ke++)A[Ke]!=null&&(L==0?Oe=At=_[Ke]:st=St=_[Ke],u.moveTo(Oe,st),u.lineTo(At,St));u.stroke(),y==1&&u.translate(-Ue,-Ue)}function kr(_){let A=!0;return M.forEach((L,D)=>{if(!L.show)return;let X=b[L.scale];if(X.min==null){L._show&&(A=!1,L._show=!1,ct(!1));return}else L._show||(A=!1,L._show=!0,ct(!1));let j=L.side,ae=j%2,{min:fe,max:_e}=X,[De,Ue]=ps(D,fe,_e,ae==0?z:Re);if(Ue==0)return;let Oe=X.distr==2,st=L._splits=L.splits(n,D,fe,_e,De,Ue,Oe),At=X.distr==2?st.map(qe=>si[qe]):st,St=X.distr==2?si[st[1]]-si[st[0]]:De,mt=L._values=L.values(n,L.filter(n,At,D,Ue,St),D,Ue,St);L._rotate=j==2?L.rotate(n,mt,D,Ue):0;let Ke=L._size;L._size=wi(L.size(n,mt,D,_)),Ke!=null&&L._size!=Ke&&(A=!1)}),A}function $i(_){let A=!0;return Zo.forEach((L,D)=>{let X=L(n,D,Xi,_);X!=Ci[D]&&(A=!1),Ci[D]=X}),A}function ms(){for(let _=0;_<M.length;_++){let A=M[_];if(!A.show||!A._show)continue;let L=A.side,D=L%2,X,j,ae=A.stroke(n,_),fe=L==0||L==3?-1:1,[_e,De]=A._found;if(A.label!=null){let $n=A.labelGap*fe,ai=_n((A._lpos+$n)*Ct);Ie(A.labelFont[0],ae,"center",L==2?"top":um),u.save(),D==1?(X=j=0,u.translate(ai,_n(S+de/2)),u.rotate((L==3?-yl:yl)/2)):(X=_n(P+$/2),j=ai);let pr=eg(A.label)?A.label(n,_,_e,De):A.label;u.fillText(pr,X,j),u.restore()}if(De==0)continue;let Ue=b[A.scale],Oe=D==0?$:de,st=D==0?P:S,At=A._splits,St=Ue.distr==2?At.map($n=>si[$n]):At,mt=Ue.distr==2?si[At[1]]-si[At[0]]:_e,Ke=A.ticks,qe=A.border,Wt=Ke.show?Ke.size:0,sn=_n(Wt*Ct),Cn=_n((A.alignTo==2?A._size-Wt-A.gap:A.gap)*Ct),Ut=A._rotate*-yl/180,rn=p(A._pos*Ct),ri=(sn+Cn)*fe,qn=rn+ri;j=D==0?qn:0,X=D==1?qn:0;let vi=A.font[0],Ri=A.align==1?Jr:A.align==2?Lu:Ut>0?Jr:Ut<0?Lu:D==0?"center":L==3?Lu:Jr,Zi=Ut||D==1?"middle":L==2?"top":um;Ie(vi,ae,Ri,Zi);let oi=A.font[1]*A.lineGap,xi=At.map($n=>p(a($n,Ue,Oe,st))),Pi=A._values;for(let $n=0;$n<Pi.length;$n++){let ai=Pi[$n];if(ai!=null){D==0?X=xi[$n]:j=xi[$n],ai=""+ai;let pr=ai.indexOf(`
`)==-1?[ai]:ai.split(/\n/gm);for(let Yn=0;Yn<pr.length;Yn++){let xp=pr[Yn];Ut?(u.save(),u.translate(X,j+Yn*oi),u.rotate(Ut),u.fillText(xp,0,0),u.restore()):u.fillText(xp,X,j+Yn*oi)}}}Ke.show&&un(xi,Ke.filter(n,St,_,De,mt),D,L,rn,sn,kt(Ke.width*Ct,3),Ke.stroke(n,_),Ke.dash,Ke.cap);let Ki=A.grid;Ki.show&&un(xi,Ki.filter(n,St,_,De,mt),D,D==0?2:1,D==0?S:P,D==0?de:$,kt(Ki.width*Ct,3),Ki.stroke(n,_),Ki.dash,Ki.cap),qe.show&&un([rn],[1],D==0?1:0,D==0?1:2,D==1?S:P,D==1?de:$,kt(qe.width*Ct,3),qe.stroke(n,_),qe.dash,qe.cap)}An("drawAxes")}function ct(_){v.forEach((A,L)=>{L>0&&(A._paths=null,_&&(s==1?(A.min=null,A.max=null):A.facets.forEach(D=>{D.min=null,D.max=null})))})}let nn=!1,Xn=!1,Nt=[];function dn(){Xn=!1;for(let _=0;_<Nt.length;_++)An(...Nt[_]);Nt.length=0}function Fn(){nn||(v_(tp),nn=!0)}function Qa(_,A=!1){nn=!0,Xn=A,_(n),tp(),A&&Nt.length>0&&queueMicrotask(dn)}n.batch=Qa;function tp(){if(oe&&(ft(),oe=!1),xe&&(we(),xe=!1),ve){if(Xt(m,Jr,Je),Xt(m,"top",ot),Xt(m,la,z),Xt(m,ca,Re),Xt(g,Jr,Je),Xt(g,"top",ot),Xt(g,la,z),Xt(g,ca,Re),Xt(d,la,en),Xt(d,ca,cn),h.width=_n(en*Ct),h.height=_n(cn*Ct),M.forEach(({_el:_,_show:A,_size:L,_pos:D,side:X})=>{if(_!=null)if(A){let j=X===3||X===0?L:0,ae=X%2==1;Xt(_,ae?"left":"top",D-j),Xt(_,ae?"width":"height",L),Xt(_,ae?"top":"left",ae?ot:Je),Xt(_,ae?"height":"width",ae?Re:z),Vu(_,_r)}else ci(_,_r)}),Fr=Fs=Or=G=ee=J=K=Ee=C=null,Pe=1,ta(!0),Je!=Se||ot!=Ft||z!=Ve||Re!=Ye){ct(!1);let _=z/Ve,A=Re/Ye;if(me&&!ne&&he.left>=0){he.left*=_,he.top*=A,Br&&is(Br,_n(he.left),0,z,Re),zr&&is(zr,0,_n(he.top),z,Re);for(let L=0;L<at.length;L++){let D=at[L];D!=null&&(Vt[L]*=_,Wn[L]*=A,is(D,wi(Vt[L]),wi(Wn[L]),z,Re))}}if(Ht.show&&!se&&Ht.left>=0&&Ht.width>0){Ht.left*=_,Ht.width*=_,Ht.top*=A,Ht.height*=A;for(let L in du)Xt(Hr,L,Ht[L])}Se=Je,Ft=ot,Ve=z,Ye=Re}An("setSize"),ve=!1}en>0&&cn>0&&(u.clearRect(0,0,h.width,h.height),An("drawClear"),w.forEach(_=>_()),An("draw")),Ht.show&&se&&(el(Ht),se=!1),me&&ne&&(fr(null,!0,!1),ne=!1),ce.show&&ce.live&&pe&&(hu(),pe=!1),l||(l=!0,n.status=1,An("ready")),Us=!1,nn=!1}n.redraw=(_,A)=>{xe=A||!1,_!==!1?ks(T,R.min,R.max):Fn()};function au(_,A){let L=b[_];if(L.from==null){if(tn==0){let D=L.range(n,A.min,A.max,_);A.min=D[0],A.max=D[1]}if(A.min>A.max){let D=A.min;A.min=A.max,A.max=D}if(tn>1&&A.min!=null&&A.max!=null&&A.max-A.min<1e-16)return;_==T&&L.distr==2&&tn>0&&(A.min=Ni(A.min,e[0]),A.max=Ni(A.max,e[0]),A.min==A.max&&A.max++),H[_]=A,oe=!0,Fn()}}n.setScale=au;let lu,cu,Br,zr,np,ip,Vr,Gr,sp,rp,Gt,Yt,Os=!1,Ln=he.drag,En=Ln.x,Tn=Ln.y;me&&(he.x&&(lu=Si(Gx,g)),he.y&&(cu=Si(Hx,g)),R.ori==0?(Br=lu,zr=cu):(Br=cu,zr=lu),Gt=he.left,Yt=he.top);let Ht=n.select=pn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Hr=Ht.show?Si(Vx,Ht.over?g:m):null;function el(_,A){if(Ht.show){for(let L in _)Ht[L]=_[L],L in du&&Xt(Hr,L,_[L]);A!==!1&&An("setSelect")}}n.setSelect=el;function Pv(_){if(v[_].show)Q&&Vu(rt[_],_r);else if(Q&&ci(rt[_],_r),me){let L=Ce?at[0]:at[_];L!=null&&is(L,-10,-10,z,Re)}}function ks(_,A,L){au(_,{min:A,max:L})}function Yi(_,A,L,D){A.focus!=null&&Uv(_),A.show!=null&&v.forEach((X,j)=>{j>0&&(_==j||_==null)&&(X.show=A.show,Pv(j),s==2?(ks(X.facets[0].scale,null,null),ks(X.facets[1].scale,null,null)):ks(X.scale,null,null),Fn())}),L!==!1&&An("setSeries",_,A),D&&na("setSeries",n,_,A)}n.setSeries=Yi;function Iv(_,A){pn(E[_],A)}function Lv(_,A){_.fill=yt(_.fill||null),_.dir=Tt(_.dir,-1),A=A??E.length,E.splice(A,0,_)}function Nv(_){_==null?E.length=0:E.splice(_,1)}n.addBand=Lv,n.setBand=Iv,n.delBand=Nv;function Dv(_,A){v[_].alpha=A,me&&at[_]!=null&&(at[_].style.opacity=A),Q&&rt[_]&&(rt[_].style.opacity=A)}let gs,Bs,dr,Wr={focus:!0};function Uv(_){if(_!=dr){let A=_==null,L=ke.alpha!=1;v.forEach((D,X)=>{if(s==1||X>0){let j=A||X==0||X==_;D._focus=A?null:j,L&&Dv(X,j?1:ke.alpha)}}),dr=_,L&&Fn()}}Q&&Qe&&Mt(mm,Ae,_=>{he._lock||(je(_),dr!=null&&Yi(null,Wr,!0,fn.setSeries))});function Ji(_,A,L){let D=b[A];L&&(_=_/Ct-(D.ori==1?ot:Je));let X=z;D.ori==1&&(X=Re,_=X-_),D.dir==-1&&(_=X-_);let j=D._min,ae=D._max,fe=_/X,_e=j+(ae-j)*fe,De=D.distr;return De==3?jr(10,_e):De==4?o_(_e,D.asinh):De==100?D.bwd(_e):_e}function Fv(_,A){let L=Ji(_,T,A);return Ni(L,e[0],on,an)}n.valToIdx=_=>Ni(_,e[0]),n.posToIdx=Fv,n.posToVal=Ji,n.valToPos=(_,A,L)=>b[A].ori==0?r(_,b[A],L?$:z,L?P:0):o(_,b[A],L?de:Re,L?S:0),n.setCursor=(_,A,L)=>{Gt=_.left,Yt=_.top,fr(null,A,L)};function op(_,A){Xt(Hr,Jr,Ht.left=_),Xt(Hr,la,Ht.width=A)}function ap(_,A){Xt(Hr,"top",Ht.top=_),Xt(Hr,ca,Ht.height=A)}let Qo=R.ori==0?op:ap,ea=R.ori==1?op:ap;function Ov(){if(Q&&ce.live)for(let _=s==2?1:0;_<v.length;_++){if(_==0&&lt)continue;let A=ce.values[_],L=0;for(let D in A)He[_][L++].firstChild.nodeValue=A[D]}}function hu(_,A){if(_!=null&&(_.idxs?_.idxs.forEach((L,D)=>{te[D]=L}):h_(_.idx)||te.fill(_.idx),ce.idx=te[0]),Q&&ce.live){for(let L=0;L<v.length;L++)(L>0||s==1&&!lt)&&kv(L,te[L]);Ov()}pe=!1,A!==!1&&An("setLegend")}n.setLegend=hu;function kv(_,A){let L=v[_],D=_==0&&U==2?si:e[_],X;lt?X=L.values(n,_,A)??it:(X=L.value(n,A==null?null:D[A],_,A),X=X==null?it:{_:X}),ce.values[_]=X}function fr(_,A,L){sp=Gt,rp=Yt,[Gt,Yt]=he.move(n,Gt,Yt),he.left=Gt,he.top=Yt,me&&(Br&&is(Br,_n(Gt),0,z,Re),zr&&is(zr,0,_n(Yt),z,Re));let D,X=on>an;gs=Ot,Bs=null;let j=R.ori==0?z:Re,ae=R.ori==1?z:Re;if(Gt<0||tn==0||X){D=he.idx=null;for(let fe=0;fe<v.length;fe++){let _e=at[fe];_e!=null&&is(_e,-10,-10,z,Re)}Qe&&Yi(null,Wr,!0,_==null&&fn.setSeries),ce.live&&(te.fill(D),pe=!0)}else{let fe,_e,De;s==1&&(fe=R.ori==0?Gt:Yt,_e=Ji(fe,T),D=he.idx=Ni(_e,e[0],on,an),De=k(e[0][D],R,j,0));let Ue=-10,Oe=-10,st=0,At=0,St=!0,mt="",Ke="";for(let qe=s==2?1:0;qe<v.length;qe++){let Wt=v[qe],sn=te[qe],Cn=sn==null?null:s==1?e[qe][sn]:e[qe][1][sn],Ut=he.dataIdx(n,qe,D,_e),rn=Ut==null?null:s==1?e[qe][Ut]:e[qe][1][Ut];if(pe=pe||rn!=Cn||Ut!=sn,te[qe]=Ut,qe>0&&Wt.show){let ri=Ut==null?-10:Ut==D?De:k(s==1?e[0][Ut]:e[qe][0][Ut],R,j,0),qn=rn==null?-10:I(rn,s==1?b[Wt.scale]:b[Wt.facets[1].scale],ae,0);if(Qe&&rn!=null){let vi=R.ori==1?Gt:Yt,Ri=bn(ke.dist(n,qe,Ut,qn,vi));if(Ri<gs){let Zi=ke.bias;if(Zi!=0){let oi=Ji(vi,Wt.scale),xi=rn>=0?1:-1,Pi=oi>=0?1:-1;Pi==xi&&(Pi==1?Zi==1?rn>=oi:rn<=oi:Zi==1?rn<=oi:rn>=oi)&&(gs=Ri,Bs=qe)}else gs=Ri,Bs=qe}}if(pe||Ce){let vi,Ri;R.ori==0?(vi=ri,Ri=qn):(vi=qn,Ri=ri);let Zi,oi,xi,Pi,Ki,$n,ai=!0,pr=ue.bbox;if(pr!=null){ai=!1;let Yn=pr(n,qe);xi=Yn.left,Pi=Yn.top,Zi=Yn.width,oi=Yn.height}else xi=vi,Pi=Ri,Zi=oi=ue.size(n,qe);if($n=ue.fill(n,qe),Ki=ue.stroke(n,qe),Ce)qe==Bs&&gs<=ke.prox&&(Ue=xi,Oe=Pi,st=Zi,At=oi,St=ai,mt=$n,Ke=Ki);else{let Yn=at[qe];Yn!=null&&(Vt[qe]=xi,Wn[qe]=Pi,Mm(Yn,Zi,oi,ai),_m(Yn,$n,Ki),is(Yn,wi(xi),wi(Pi),z,Re))}}}}if(Ce){let qe=ke.prox,Wt=dr==null?gs<=qe:gs>qe||Bs!=dr;if(pe||Wt){let sn=at[0];sn!=null&&(Vt[0]=Ue,Wn[0]=Oe,Mm(sn,st,At,St),_m(sn,mt,Ke),is(sn,wi(Ue),wi(Oe),z,Re))}}}if(Ht.show&&Os)if(_!=null){let[fe,_e]=fn.scales,[De,Ue]=fn.match,[Oe,st]=_.cursor.sync.scales,At=_.cursor.drag;if(En=At._x,Tn=At._y,En||Tn){let{left:St,top:mt,width:Ke,height:qe}=_.select,Wt=_.scales[Oe].ori,sn=_.posToVal,Cn,Ut,rn,ri,qn,vi=fe!=null&&De(fe,Oe),Ri=_e!=null&&Ue(_e,st);vi&&En?(Wt==0?(Cn=St,Ut=Ke):(Cn=mt,Ut=qe),rn=b[fe],ri=k(sn(Cn,Oe),rn,j,0),qn=k(sn(Cn+Ut,Oe),rn,j,0),Qo(Di(ri,qn),bn(qn-ri))):Qo(0,j),Ri&&Tn?(Wt==1?(Cn=St,Ut=Ke):(Cn=mt,Ut=qe),rn=b[_e],ri=I(sn(Cn,st),rn,ae,0),qn=I(sn(Cn+Ut,st),rn,ae,0),ea(Di(ri,qn),bn(qn-ri))):ea(0,ae)}else fu()}else{let fe=bn(sp-np),_e=bn(rp-ip);if(R.ori==1){let st=fe;fe=_e,_e=st}En=Ln.x&&fe>=Ln.dist,Tn=Ln.y&&_e>=Ln.dist;let De=Ln.uni;De!=null?En&&Tn&&(En=fe>=De,Tn=_e>=De,!En&&!Tn&&(_e>fe?Tn=!0:En=!0)):Ln.x&&Ln.y&&(En||Tn)&&(En=Tn=!0);let Ue,Oe;En&&(R.ori==0?(Ue=Vr,Oe=Gt):(Ue=Gr,Oe=Yt),Qo(Di(Ue,Oe),bn(Oe-Ue)),Tn||ea(0,ae)),Tn&&(R.ori==1?(Ue=Vr,Oe=Gt):(Ue=Gr,Oe=Yt),ea(Di(Ue,Oe),bn(Oe-Ue)),En||Qo(0,j)),!En&&!Tn&&(Qo(0,0),ea(0,0))}if(Ln._x=En,Ln._y=Tn,_==null){if(L){if(vp!=null){let[fe,_e]=fn.scales;fn.values[0]=fe!=null?Ji(R.ori==0?Gt:Yt,fe):null,fn.values[1]=_e!=null?Ji(R.ori==1?Gt:Yt,_e):null}na(Nu,n,Gt,Yt,z,Re,D)}if(Qe){let fe=L&&fn.setSeries,_e=ke.prox;dr==null?gs<=_e&&Yi(Bs,Wr,!0,fe):gs>_e?Yi(null,Wr,!0,fe):Bs!=dr&&Yi(Bs,Wr,!0,fe)}}pe&&(ce.idx=D,hu()),A!==!1&&An("setCursor")}let zs=null;Object.defineProperty(n,"rect",{get(){return zs==null&&ta(!1),zs}});function ta(_=!1){_?zs=null:(zs=g.getBoundingClientRect(),An("syncRect",zs))}function lp(_,A,L,D,X,j,ae){he._lock||Os&&_!=null&&_.movementX==0&&_.movementY==0||(uu(_,A,L,D,X,j,ae,!1,_!=null),_!=null?fr(null,!0,!0):fr(A,!0,!1))}function uu(_,A,L,D,X,j,ae,fe,_e){if(zs==null&&ta(!1),je(_),_!=null)L=_.clientX-zs.left,D=_.clientY-zs.top;else{if(L<0||D<0){Gt=-10,Yt=-10;return}let[De,Ue]=fn.scales,Oe=A.cursor.sync,[st,At]=Oe.values,[St,mt]=Oe.scales,[Ke,qe]=fn.match,Wt=A.axes[0].side%2==1,sn=R.ori==0?z:Re,Cn=R.ori==1?z:Re,Ut=Wt?j:X,rn=Wt?X:j,ri=Wt?D:L,qn=Wt?L:D;if(St!=null?L=Ke(De,St)?a(st,b[De],sn,0):-10:L=sn*(ri/Ut),mt!=null?D=qe(Ue,mt)?a(At,b[Ue],Cn,0):-10:D=Cn*(qn/rn),R.ori==1){let vi=L;L=D,D=vi}}_e&&(A==null||A.cursor.event.type==Nu)&&((L<=1||L>=z-1)&&(L=vr(L,z)),(D<=1||D>=Re-1)&&(D=vr(D,Re))),fe?(np=L,ip=D,[Vr,Gr]=he.move(n,L,D)):(Gt=L,Yt=D)}let du={width:0,height:0,left:0,top:0};function fu(){el(du,!1)}let cp,hp,up,dp;function fp(_,A,L,D,X,j,ae){Os=!0,En=Tn=Ln._x=Ln._y=!1,uu(_,A,L,D,X,j,ae,!0,!1),_!=null&&(Mt(Du,Bu,pp,!1),na(fm,n,Vr,Gr,z,Re,null));let{left:fe,top:_e,width:De,height:Ue}=Ht;cp=fe,hp=_e,up=De,dp=Ue}function pp(_,A,L,D,X,j,ae){Os=Ln._x=Ln._y=!1,uu(_,A,L,D,X,j,ae,!1,!0);let{left:fe,top:_e,width:De,height:Ue}=Ht,Oe=De>0||Ue>0,st=cp!=fe||hp!=_e||up!=De||dp!=Ue;if(Oe&&st&&el(Ht),Ln.setScale&&Oe&&st){let At=fe,St=De,mt=_e,Ke=Ue;if(R.ori==1&&(At=_e,St=Ue,mt=fe,Ke=De),En&&ks(T,Ji(At,T),Ji(At+St,T)),Tn)for(let qe in b){let Wt=b[qe];qe!=T&&Wt.from==null&&Wt.min!=Ot&&ks(qe,Ji(mt+Ke,qe),Ji(mt,qe))}fu()}else he.lock&&(he._lock=!he._lock,fr(A,!0,_!=null));_!=null&&(gn(Du,Bu),na(Du,n,Gt,Yt,z,Re,null))}function Bv(_,A,L,D,X,j,ae){if(he._lock)return;je(_);let fe=Os;if(Os){let _e=!0,De=!0,Ue=10,Oe,st;R.ori==0?(Oe=En,st=Tn):(Oe=Tn,st=En),Oe&&st&&(_e=Gt<=Ue||Gt>=z-Ue,De=Yt<=Ue||Yt>=Re-Ue),Oe&&_e&&(Gt=Gt<Vr?0:z),st&&De&&(Yt=Yt<Gr?0:Re),fr(null,!0,!0),Os=!1}Gt=-10,Yt=-10,te.fill(null),fr(null,!0,!0),fe&&(Os=fe)}function mp(_,A,L,D,X,j,ae){he._lock||(je(_),jo(),fu(),_!=null&&na(gm,n,Gt,Yt,z,Re,null))}function gp(){M.forEach(Tb),B(n.width,n.height,!0)}br(vl,Kr,gp);let Xr={};Xr.mousedown=fp,Xr.mousemove=lp,Xr.mouseup=pp,Xr.dblclick=mp,Xr.setSeries=(_,A,L,D)=>{let X=fn.match[2];L=X(n,A,L),L!=-1&&Yi(L,D,!0,!1)},me&&(Mt(fm,g,fp),Mt(Nu,g,lp),Mt(pm,g,_=>{je(_),ta(!1)}),Mt(mm,g,Bv),Mt(gm,g,mp),$u.add(n),n.syncRect=ta);let tl=n.hooks=i.hooks||{};function An(_,A,L){Xn?Nt.push([_,A,L]):_ in tl&&tl[_].forEach(D=>{D.call(null,n,A,L)})}(i.plugins||[]).forEach(_=>{for(let A in _.hooks)tl[A]=(tl[A]||[]).concat(_.hooks[A])});let yp=(_,A,L)=>L,fn=pn({key:null,setSeries:!1,filters:{pub:Am,sub:Am},scales:[T,v[1]?v[1].scale:null],match:[Cm,Cm,yp],values:[null,null]},he.sync);fn.match.length==2&&fn.match.push(yp),he.sync=fn;let vp=fn.key,pu=wg(vp);function na(_,A,L,D,X,j,ae){fn.filters.pub(_,A,L,D,X,j,ae)&&pu.pub(_,A,L,D,X,j,ae)}pu.sub(n);function zv(_,A,L,D,X,j,ae){fn.filters.sub(_,A,L,D,X,j,ae)&&Xr[_](null,A,L,D,X,j,ae)}n.pub=zv;function Vv(){pu.unsub(n),$u.delete(n),wn.clear(),Gu(vl,Kr,gp),c.remove(),Ae?.remove(),An("destroy")}n.destroy=Vv;function mu(){An("init",i,e),Ko(e||i.data,!1),H[T]?au(T,H[T]):jo(),se=Ht.show&&(Ht.width>0||Ht.height>0),ne=pe=!0,B(i.width,i.height)}return v.forEach(Ur),M.forEach(ds),t?t instanceof HTMLElement?(t.appendChild(c),mu()):t(n,mu):mu(),n}Nn.assign=pn;Nn.fmtNum=ed;Nn.rangeNum=xl;Nn.rangeLog=Ml;Nn.rangeAsinh=ju;Nn.orient=Sr;Nn.pxRatio=Ct;Nn.join=y_;Nn.fmtDate=nd,Nn.tzDate=C_;Nn.sync=wg;{Nn.addGap=hb,Nn.clipGaps=El;let i=Nn.paths={points:Pg};i.linear=Lg,i.stepped=fb,i.bars=pb,i.spline=gb}function Fg(i,e,t){let{time:n,values:s}=i,r=n.length;if(r<=2*t)return i;let o=e/t,a=Math.floor((n[0]??0)/o),l=Math.floor((n[r-1]??0)/o)-a+1,c={time:new Float64Array(2*l),values:s.map(()=>new Float32Array(2*l).fill(NaN))};for(let h=0;h<2*l;h++)c.time[h]=(a+h/2)*o;return s.forEach((h,u)=>{let d=c.values[u];if(!d)return;let m=0;for(let g=0;g<l;g++){let[y,p,f,v]=[1/0,-1/0,-1,-1];for(;m<r&&Math.floor((n[m]??0)/o)-a<=g;m++){let M=h[m]??NaN;M<y&&([y,f]=[M,m]),M>p&&([p,v]=[M,m])}f<0||(d[2*g]=f<=v?y:p,d[2*g+1]=f<=v?p:y)}}),c}function Og(i){let[e,t]=[1/0,-1/0];for(let n of i)for(let s=0;s<n.length;s++){let r=n[s]??NaN;r<e&&(e=r),r>t&&(t=r)}return e<=t?[e,t]:null}var Rl=class{constructor(e){this.floor=e}floor;low=0;high=0;fit(e){let[t,n]=e?[Math.min(e[0],0),Math.max(e[1],0)]:[0,0],s=.08*Math.max(n-t,this.floor),[r,o]=[t<0?t-s:0,n>0||t===0?Math.max(n,t===0?this.floor:0)+s:0];return this.low=r<this.low?r:this.low+(r-this.low)*.04,this.high=o>this.high?o:this.high+(o-this.high)*.04,[this.low,Math.max(this.high,this.low+this.floor)]}};function kg(i,e){let n=[i.map(s=>/[",\n]/.test(s)?`"${s.replaceAll('"','""')}"`:s).join(",")];for(let s=0;s<e.time.length;s++){let r=e.values.map(o=>Number.isNaN(o[s])?"":String(Number((o[s]??NaN).toPrecision(7))));n.push([(e.time[s]??NaN).toFixed(4),...r].join(","))}return`${n.join(`
`)}
`}var Ab={N:.05,J:.2},Cb=[[1,""],[.001,"m"],[1e-6,"µ"],[1e-9,"n"]],Rb=Array.from({length:22},(i,e)=>[1,2,5].map(t=>+`${t}e${e-14}`)).flat(),Pb=.4;function cd(i){return getComputedStyle(document.documentElement).getPropertyValue(i).trim()}function Ib(i,e,t,n){let s=i.data[e],r=[],o=a=>i.valToPos(i.data[0][Math.min(Math.max(a,0),i.data[0].length-1)]??0,"x",!0);for(let a=t;s&&a<=n;a++){if(!Number.isNaN(s[a]))continue;let l=a;for(;l<n&&Number.isNaN(s[l+1]);)l++;(i.data[0][l+1]??1/0)-(i.data[0][a-1]??-1/0)>Pb&&r.push([o(a-1),o(l+1)]),a=l}return r}var ro=class{constructor(e,t,n,s,r,o,a){this.what=e;this.unit=t;this.lines=s;this.axis=new Rl(n),this.readout=s.map(d=>O("span",{class:"reading",title:d.name}));let l=O("div",{class:"chart-area",role:"img","aria-label":`${e} of the last ${r} s`});this.element=O("figure",{class:"chart"},O("figcaption",{"data-tip":a,tabindex:0},O("strong",null,e),this.unitWords,O("span",{class:"readings tabular"},...this.readout)),l);let c=()=>cd("--muted"),h=()=>cd("--rule"),u=`11px ${cd("--sans")||"system-ui"}`;this.plot=new Nn({width:200,height:90,padding:[6,16,0,0],legend:{show:!1},cursor:{y:!1,drag:{x:!1,y:!1},points:{size:5},sync:{key:o}},scales:{x:{time:!1,range:[-r,0]},y:{range:()=>this.limits}},axes:[{stroke:c,font:u,size:20,gap:2,space:38,incrs:[1,2,5,10,20],grid:{stroke:h,width:1},ticks:{show:!1},values:(d,m)=>m.map(g=>g===0?"now":g===-r?"":`${Zn(g)} s`)},{stroke:c,font:u,size:38,gap:4,space:20,incrs:Rb,grid:{stroke:h,width:1},ticks:{show:!1},values:(d,m,g,y,p)=>{let f=Math.max(0,-Math.floor(Math.log10(p/this.scale+1e-12)));return m.map(v=>Zn(v/this.scale,Math.min(f,3)))}}],series:[{},...s.map(d=>({label:d.name,stroke:d.colour,width:1.5,points:{show:!1},spanGaps:!1,gaps:(m,g,y,p)=>Ib(m,g,y,p),...d.dash?{dash:d.dash}:{}}))],hooks:{setCursor:[()=>this.read()]}},[[],...s.map(()=>[])],l),this.observer=new ResizeObserver(([d])=>{let{width:m=0,height:g=0}=d?.contentRect??{};m>20&&g>20&&this.plot.setSize({width:Math.floor(m),height:Math.floor(g)})}),this.observer.observe(l)}what;unit;lines;element;unitWords=O("span",{class:"unit"});readout;plot;axis;scale=1;limits=[0,1];observer;draw(e,t){let n=new Float64Array(e.time.length);for(let a=0;a<n.length;a++)n[a]=(e.time[a]??0)-t;this.limits=this.axis.fit(Og(e.values));let s=Math.max(Math.abs(this.limits[0]),Math.abs(this.limits[1])),[r,o]=Cb.find(([a])=>s>=a*(Ab[this.unit]??1))??[1e-9,"n"];this.scale=r,Le(this.unitWords,o+this.unit),this.lines.forEach((a,l)=>{let c=this.plot.series[l+1];c&&(c.width=a.width())}),this.plot.setData([n,...e.values],!0),this.read()}redraw(){this.plot.redraw(!1,!0)}get canvas(){return this.plot.ctx.canvas}get caption(){return`${this.what} [${this.unitWords.textContent??""}]`}get room(){return Math.max(this.plot.width-46,100)}dispose(){this.observer.disconnect(),this.plot.destroy(),this.element.remove()}read(){let e=this.plot.cursor.idx,t=this.plot.data[0].length-1;this.lines.forEach((n,s)=>{let r=this.readout[s],o=this.plot.data[s+1];if(!r||!o)return;let a=o[e??t],l=Math.abs((a??0)/this.scale),c=this.plot.width/this.lines.length<36?1:2,h=Math.max(0,l<9.995?c:l<99.95?c-1:0);Le(r,a==null||Number.isNaN(a)?"–":Zn(a/this.scale,h)),r.style.setProperty("--user",n.colour())})}};var Lb=20,oo=128;function Bg(i){let{store:e}=i,t=O("div",{class:"charts charts-one"}),n=new Float64Array(oo),s=new Map,r=new Float32Array(oo).fill(NaN),o=0,a=null,l=[],c="",h=y=>getComputedStyle(document.documentElement).getPropertyValue(y).trim(),u=y=>Qi(i.link.get(),y),d=()=>{let y=e.state;if(!y||o&&y.time<=(n[o-1]??0))return;if(o===oo){n.copyWithin(0,1);for(let f of[...s.values(),r])f.copyWithin(0,1);o--}n[o]=y.time;for(let f of s.values())f[o]=NaN;for(let f of l){let v=s.get(Jn(f))??new Float32Array(oo).fill(NaN);s.set(Jn(f),v),v[o]=Ii(y,...f,"ages")??NaN}let p=i.link.get();r[o]=(p&&Ii(y,...p,"budget"))??NaN,o++;for(let[f,v]of s)v.subarray(0,o).every(Number.isNaN)&&s.delete(f)},m=()=>{let y=(e.state?.links??[]).map(([f,v])=>ji(f,v)),p=JSON.stringify([e.scene?.started,y]);p!==c&&(c.startsWith(JSON.stringify([e.scene?.started]).slice(0,-1))||([n,s,r,o]=[new Float64Array(oo),new Map,new Float32Array(oo).fill(NaN),0]),c=p,l=y,a?.dispose(),a=null,l.length&&(a=new ro("Ages there and back","s",.01,[...l.map(f=>({name:ts(...f),colour:()=>h(u(f)?"--accent":"--faint"),width:()=>u(f)?2.25:1})),{name:"budget",colour:()=>h("--warn"),width:()=>1.25,dash:[5,4]}],Lb,"ages","Sum of the ages at both ends of every link. Choose a link to make it and its budget stand out"),t.replaceChildren(a.element))),d(),g()},g=()=>{if(!a||!o||t.offsetParent===null)return;let y={time:n.subarray(0,o),values:[...l.map(p=>s.get(Jn(p))?.subarray(0,o)??new Float32Array(o).fill(NaN)),r.subarray(0,o)]};a.draw(y,n[o-1]??0)};return e.on("state",m),e.on("settings",()=>a?.redraw()),i.link.on(()=>{r.fill(NaN),g()}),i.tab.on(g),t}var zg=" N·s/m",Nb={spring:"Each link is a spring to the newest sample; damping pays for the ages of samples, and is felt as drag.",paid:"Copies exchange what hands do, and predict it; each push is paid from an account. It needs no damping.",wave:"Each link is a wave line: no drag but what calms its reflections, and some mass instead.",tank:"Springs and dampers, paid from a tank that a damper fills."};function Db(i,e){let t=i/e;return t<-1?"for now links give back what they held":t<1?"less than people notice":`${Zn(t,t<9.95?1:0)} times what people notice`}function Vg(){let i=O("dd",{tabindex:0}),e=O("dd"),t=O("dd"),n=O("dd",{class:"means"}),s=(l,c)=>O("dt",{"data-tip":c,tabindex:0},l),r=s("energy on its way","What ends of links gave, and the others did not take yet"),o=s("felt drag","What the law takes of the motion, for each N·s/m that a hand would feel"),a=O("dl",{class:"law tabular",hidden:!0},O("dt",null,"law of the links"),i,r,e,o,t,n);return{element:a,show(l,c){if(dt(a,l!==null),!l)return;Le(i,l.law),Ge(i,"data-tip",Nb[l.law]??null),dt(r,l.on_the_way!==null),dt(e,l.on_the_way!==null),Le(e,Ws(l.on_the_way,"J",1e-9));let[h,u]=l.measured!==null?[l.measured,"measured"]:[l.predicted,"predicted"],d=l.measured!==null&&l.predicted!==null?`, predicted ${Zn(l.predicted,2)}`:"";Le(t,h===null?"–":`${Zn(h,2)}${zg} ${u}${d}${c?", at each node":""}`),Ge(t,"data-how",h===null?null:u);let m=`from ${Zn(l.noticed,1)}${zg}`,g=h===null?"":c?`A hand feels that of all nodes that move with it; people notice it ${m}.`:`${Db(h,l.noticed)} (${m})`;Le(n,h===null?"Known once the object moves.":g)}}}var Ub="Safe, or passive, means: whatever the users do, the session as a whole never gives out more energy than hands put in, so nothing can start to swing by itself. It holds as long as each copy’s damping is at least what the ages on its links ask for. Damping is made for a budget of ages on each link; what ages leave of it is to spare. A link that goes over its budget is guarded: it then spends only what it has saved. Other laws than springs need no such damping, and no budget: they pay for what they do.",[Wg,Fb]=[.1,100],hd={skin:1,bare:5};function Gg(i){return Math.min(Number((Wg*10**(i/10)).toPrecision(2)),95)}var ud=i=>Math.round(10*Math.log10(i/Wg)),Hg=ud(Fb);function Ob(i){let e=O("output",{class:"tabular"}),t=O("input",{type:"range",min:0,max:Hg,step:1,value:ud(hd.bare),"aria-label":"Share of the damping that is needed"}),n=()=>{let o=`${Gg(Number(t.value))} % of what is needed`;Le(e,o),Ge(t,"aria-valuetext",o),t.style.setProperty("--share",`${Number(t.value)/Hg*100}%`)};t.addEventListener("input",n),n();let s=yr("Lower the damping",[O("p",{class:"warning"},vn("warn",20),O("span",null,"Below what the delays need, nothing keeps energy from growing: copies begin to shake by themselves, and shake harder until they are stopped. That is what you will see, in numbers and in the picture.")),O("p",null,"Do this with simulated hands only. Let go of any real device first."),O("label",{class:"slider"},O("span",null,"damping"),t,e),O("p",{class:"hint"},"Scripted hands let go meanwhile. It holds only while this page is open and answers. A copy that runs away restores the damping of all by itself; so does one click on the banner.")],[{words:"Lower it",class:"button danger",act:()=>{i.act({what:"damping",fraction:Number((Gg(Number(t.value))/100).toPrecision(3))})}},{words:"Leave it as it is",class:"button primary",act:()=>{},focus:!0}]),r;return{open:()=>{let{scene:o}=i.store;o&&o.started!==r&&(r=o.started,t.value=String(ud(o.skin?hd.skin:hd.bare)),n()),s.open()}}}function Xg(i){let{store:e}=i,t=Ob(i),n=$e("Lower damping …",()=>t.open(),{icon:"warn",class:"button small danger",id:"lower",tip:"Shows what the damping is for"}),s=$e("Restore damping",()=>{i.act({what:"damping",fraction:1})},{class:"button small primary"}),{element:r,body:o}=bi("margin","Margin",Ub,n,s),a=O("tbody"),l=O("tbody"),c=Vg();o.append(c.element,O("table",{class:"numbers"},O("thead",null,O("tr",null,...["link","ages","of budget","to spare",""].map(u=>O("th",{scope:"col"},u)))),a),Bg(i),O("table",{class:"numbers"},O("thead",null,O("tr",null,O("th",{scope:"col"},"user"),O("th",{scope:"col","data-tip":"Largest coefficient of the damping of the copy",tabindex:0},"damping"),O("th",{scope:"col","data-tip":"What the damping exceeds what the budgets in force need by",tabindex:0},"above need"))),l));let h=()=>{let u=e.state,d=!!u&&u.damping<1;if(dt(n,!d&&!!e.scene?.may.includes("damping")),dt(s,d),n.disabled=s.disabled=!Et(i,"damping"),!u||o.offsetParent===null)return;c.show(u.law,(e.scene?.nodes.count??1)>1);let m=u.links.map(([f,v])=>ji(f,v)),g=JSON.stringify([m,e.scene?.started]);a.dataset.key!==g&&(a.dataset.key=g,a.replaceChildren(...m.map(f=>O("tr",{"data-link":Jn(f)},O("th",{scope:"row"},$e(ts(...f),()=>i.link.set(f),{class:"plain",label:`Open link ${ts(...f)}`})),O("td"),O("td"),O("td",{class:"gauge"},O("i"),O("span")),O("td",{class:"word"}))))),m.forEach((f,v)=>{let M=a.children[v]?.children;if(!M)return;let b=qs(u,...f),E=hl(u,...f);Ge(a.children[v],"data-condition",b),Ge(a.children[v],"data-chosen",Qi(f,i.link.get())?"":null),Le(M[1],kn(Ii(u,...f,"ages"))),Le(M[2],kn(Ii(u,...f,"budget")));let T=M[3];T.style.setProperty("--share",`${Math.round(100*Math.min(Math.max(1-(E??1),0),1))}%`),Ge(T,"data-level",E===null?null:E<0?"bad":E<.1?"warn":"good"),Le(T.lastElementChild,E===null?"–":E<0?`${xn(-E,0)} over`:xn(E,0)),Le(M[4],li[b].words)});let y=Object.keys(u.members).map(Number).sort((f,v)=>f-v),p=JSON.stringify([y,e.scene?.started]);l.dataset.key!==p&&(l.dataset.key=p,l.replaceChildren(...y.map(f=>O("tr",null,O("th",{scope:"row"},O("span",{class:"badge tiny",style:`--user:var(--user-${f});--on-user:var(--on-user-${f})`},String(f+1))," ",wt(e,f)),O("td"),O("td"))))),y.forEach((f,v)=>{let M=l.children[v]?.children,b=u.members[f];if(!M||!b)return;Le(M[1],b.steps?`${Zn(b.damping,2)} N·s/m`:"–");let E=b.certificate;Le(M[2],typeof E=="number"?xn(E):"–"),Ge(M[2],"data-level",typeof E=="number"?E<0?"bad":"good":null)})};return e.on("state",h),e.on("connection",h),i.tab.on(h),i.link.on(h),h(),r}var kb="The last 20 seconds of every copy, in the colours of the users; the line of the user that this page acts for is wider. Displacement is the mean of all points (along x where the object moves along a line, else how far in all), force is the hand’s on the copy, energy is what the copy holds in motion and springs. Move over a plot to read values; without, the newest are shown. Saved numbers are not thinned.",Bb=45,zb={kind:"x",what:"Displacement x",unit:"m",floor:.002,tip:"Mean displacement of each copy from rest, along x"},qg=[{kind:"displacement",what:"Displacement",unit:"m",floor:.002,tip:"Mean displacement of each copy from rest, how far in all"},{kind:"force",what:"Force",unit:"N",floor:.05,tip:"Of each user’s hand on the copy"},{kind:"energy",what:"Energy",unit:"J",floor:1e-5,tip:"In each copy: of its motion and its springs"}];function $g(i,e){let t=URL.createObjectURL(e);O("a",{href:t,download:i}).click(),setTimeout(()=>URL.revokeObjectURL(t),1e3)}function Yg(i){let{store:e}=i,t=null,n=0,s=[],r=[],o=()=>e.scene?.dimension===1?[zb,...qg.slice(1)]:qg,a=()=>[...["x","y","z"].slice(0,e.scene?.dimension??3).map(E=>({kind:E,head:`displacement_${E}_m`})),{kind:"force",head:"force_N"},{kind:"energy",head:"energy_J"}],l=0,c=-1,h=E=>t?.get(E)??{time:e.history.time(),values:r.map(T=>e.history.series(E,T))},u=()=>{if(t)return n;let E=e.frame;return E?E.time+Math.min((performance.now()-E.received)/1e3,e.connection==="open"?.25:0):0},d=()=>{t?t=null:(n=u(),t=new Map([...o(),...a()].map(({kind:T})=>[T,h(T)])));let E=m.querySelector("svg");E&&On(E,t?"play":"pause"),Le(m.lastElementChild??m,t?"Go on":"Freeze"),m.setAttribute("aria-pressed",String(!!t)),p.toggleAttribute("data-frozen",!!t),c=-1},m=$e("Freeze",d,{icon:"pause",class:"button small",id:"freeze"}),g=$e("CSV",()=>{let E=a().map(({kind:w,head:F})=>({head:F,table:h(w)})),T=["time_s",...E.flatMap(({head:w})=>r.map(F=>`${w} ${F+1} ${wt(e,F)}`))],x=kg(T,{time:E[0].table.time,values:E.flatMap(w=>w.table.values)});$g("cotouch.csv",new Blob([x],{type:"text/csv"}))},{icon:"save",class:"button small",label:"Save the numbers as CSV"}),y=$e("PNG",()=>{Vb(i,s,r)?.toBlob(E=>E&&$g("cotouch.png",E))},{icon:"save",class:"button small",label:"Save the plots as a picture"}),{element:p,body:f}=bi("plots","Plots",kb,m,g,y);f.classList.add("charts");let v="",M=()=>{let E=e.scene,T=E?JSON.stringify([E.started,E.users,E.dimension]):"";if(T!==v){v=T,t&&d();for(let x of s)x.dispose();r=(E?.users??[]).map(x=>x.slot),s=o().map(({what:x,unit:w,floor:F,tip:N})=>new ro(x,w,F,r.map(R=>({name:wt(e,R),colour:()=>_i(R,Vs(e.settings.theme)),width:()=>R===e.slot?2.25:1.25})),e.history.seconds,"users",N)),f.replaceChildren(...s.map(x=>x.element)),c=-1}},b=E=>{if(requestAnimationFrame(b),E-l<Bb||!s.length||f.offsetParent===null||c===e.history.version&&(t||e.connection!=="open")||t&&c>=0)return;l=E,c=e.history.version;let T=u();o().forEach(({kind:x},w)=>{let F=s[w];F?.draw(Fg(h(x),e.history.seconds,F.room),T)})};return e.on("scene",M),e.on("settings",()=>{for(let E of s)E.redraw()}),M(),requestAnimationFrame(b),{element:p,freeze:d}}function Vb(i,e,t){if(!e[0]?.canvas)return null;let s=getComputedStyle(document.documentElement),r=devicePixelRatio||1,o=22*r,a=O("canvas",{width:Math.max(...e.map(m=>m.canvas.width))+2*o,height:e.reduce((m,g)=>m+g.canvas.height+o,3*o)}),l=a.getContext("2d");if(!l)return null;l.fillStyle=s.getPropertyValue("--panel"),l.fillRect(0,0,a.width,a.height),l.textBaseline="middle";let c=(m,g,y,p,f)=>(l.font=`${p} ${12*r}px system-ui, sans-serif`,l.fillStyle=f,l.fillText(m,g,y),l.measureText(m).width),h=s.getPropertyValue("--ink"),u=o;for(let m of t)l.fillStyle=_i(m,Vs(i.store.settings.theme)),l.fillRect(u,o-5*r,10*r,10*r),u+=15*r,u+=c(wt(i.store,m),u,o,400,h)+16*r;let d=2*o;for(let m of e)c(m.caption,o,d,600,h),l.drawImage(m.canvas,o,d+o/2),d+=m.canvas.height+o;return a}var Jg=350;function Zg(i){let e=O("div",{class:"tip",role:"tooltip",id:"tip",hidden:!0});i.append(e);let t=0,n=null,s=()=>{clearTimeout(t),e.hidden=!0,n?.removeAttribute("aria-describedby"),n=null},r=a=>{let l=a.getAttribute("data-tip");if(!l||!a.isConnected)return;Le(e,l),(a.closest("dialog")??i).append(e),e.hidden=!1,a.setAttribute("aria-describedby","tip");let c=a.getBoundingClientRect(),h=e.getBoundingClientRect(),u=Math.min(Math.max(c.left+c.width/2-h.width/2,8),innerWidth-h.width-8),d=c.bottom+8+h.height<innerHeight;e.style.left=`${u}px`,e.style.top=`${d?c.bottom+8:c.top-h.height-8}px`},o=(a,l)=>{let c=a.target?.closest?.("[data-tip]")??null;c!==n&&(s(),c&&(n=c,t=window.setTimeout(()=>r(c),l)))};document.addEventListener("pointerover",a=>{a.pointerType!=="touch"&&o(a,Jg)}),document.addEventListener("focusin",a=>{a.target.matches(":focus-visible")&&o(a,Jg)}),document.addEventListener("focusout",s),document.addEventListener("pointerdown",s,!0),document.addEventListener("keydown",s,!0),document.addEventListener("scroll",s,!0)}function Kg(i,e){let{store:t}=i,n=gr("Tool",[{value:"grab",words:"Grab",icon:"grab",tip:"Take hold of a point and drag it (B changes the tool)"},{value:"ball",words:"Ball",icon:"ball",tip:"Push with a ball; Shift and wheel change its size"}],h=>t.set({tool:h})),s=gr("Copies",[{value:"overlay",words:"Overlaid",icon:"overlay",tip:"All copies in one place (S)"},{value:"side",words:"Side by side",icon:"side",tip:"Each copy by itself: see how late the others are (S)"}],h=>t.set({layout:h})),r=O("select",{"aria-label":"Colour of the object","data-tip":"What colours show (C)"},O("option",{value:"displacement"},"Displacement"),O("option",{value:"stress"},"Stretch"),O("option",{value:"plain"},"Plain"));r.addEventListener("change",()=>t.set({colour:r.value}));let o=$e("Ghosts",()=>t.set({ghosts:!t.settings.ghosts}),{icon:"ghosts",class:"button small toggle",tip:"Show what others’ copies look like over yours"}),a=$e("",e,{icon:"reset",class:"button small bare",label:"Look from the start again",tip:"Look from where you looked at first (0)"}),l=O("div",{class:"toolbar",id:"toolbar",role:"toolbar","aria-label":"Picture"},O("span",{class:"space-only"},n.element),O("span",{class:"space-only"},s.element),O("span",{class:"space-only select"},r),o,a),c=()=>{let{settings:h,scene:u}=t;n.mark(h.tool),s.mark(h.layout),r.value=h.colour,Ge(o,"aria-pressed",String(h.ghosts)),Ge(l,"data-dimension",u?String(u.dimension):null),o.disabled=u?.dimension!==1&&h.layout==="side"};return t.on("settings",c),t.on("scene",c),c(),l}function Gb(i,e){let t=Math.min(i.left+i.width,e.left+e.width)-Math.max(i.left,e.left),n=Math.min(i.top+i.height,e.top+e.height)-Math.max(i.top,e.top);return Math.max(t,0)*Math.max(n,0)}function jg(i,e,t){let[n,s]=[t.left+t.width-i.width,t.top+t.height-i.height],r=(h,u)=>e.flatMap(d=>[d[h]-i[u]-12,d[h],d[h]+d[u]-i[u],d[h]+d[u]+12]),o=(h,u,d)=>[...new Set([u,d,...h.filter(m=>m>u&&m<d)])],a=e[0]??t,l={left:t.left,top:Math.max(s,t.top)},c=1/0;for(let h of o(r("left","width"),t.left,Math.max(n,t.left)))for(let u of o(r("top","height"),t.top,Math.max(s,t.top))){let d={left:h,top:u,...i},m=e.reduce((p,f,v)=>p+(v?1:4)*Gb(d,f),0),g=Math.hypot(h+i.width/2-a.left-a.width/2,u+i.height/2-a.top-a.height/2),y=1e3*m+g;y<c&&([l,c]=[{left:h,top:u},y])}return l}var md="cotouch.tour",Hb="#energy, #plots, #network",Wb=200,Il=(i,e)=>t=>Et(t,i)?null:e,e0=i=>i.store.frame?.copies.find(e=>e.slot===i.store.slot),Js=i=>{let e=e0(i);return e?.mode==="grab"||e?.mode==="ball"},Qg=i=>Math.hypot(...e0(i)?.force??[0,0,0]),Pl=Il("hand","This page may only watch; go on with →."),dd=i=>i.map(([e,t])=>Jn(ji(e,t))).sort().join(" "),fd=({store:{state:i}})=>i?.links.filter(([e,t])=>Yr(i,e,t))??[],Ui=[{title:"Take hold",words:"This is one object, held by several people. Each of them has a copy of it, and yours is the solid one.",task:"Press on the object, and drag.",where:"#stage",needs:Pl,done:i=>Js(i)&&Qg(i)>.02},{title:"Let go",words:"What you feel is a spring between your pointer and the point you hold. The others feel you through springs between the copies.",task:"Release, and watch the object swing back and come to rest.",where:"#stage",needs:Pl,done:(i,e)=>(Js(i)&&(e.held=!0),!!e.held&&!Js(i))},{title:"See the delay",words:"News travels tens of milliseconds. The other copies do what yours did, but later.",task:"Choose Side by side (or Ghosts), then drag again and look at the others.",where:"#stage-frame",needs:Pl,done:(i,e)=>{let{layout:t,ghosts:n}=i.store.settings,s=e.first??=`${t} ${n}`;return(t==="side"||`${t} ${n}`!==s)&&(e.seen=!0),!!e.seen&&Js(i)}},{title:"Pull against somebody",words:"A scripted hand can be told what to do. Two who pull against each other feel each other’s force, through the network.",task:"Unfold another user, tell the hand Hold or Pull, and drag the other way.",where:i=>i.told?"#stage":"#users",sees:"#stage, #users",tab:"users",needs:Pl,done:(i,e)=>{let{state:t,slot:n}=i.store;return Object.entries(t?.members??{}).some(([r,o])=>Number(r)!==n&&(o.hand==="hold"||o.hand==="pull"))&&(e.told=!0),!!e.told&&Js(i)&&Qg(i)>.02}},{title:"Look at a link",words:"Lines join users. The number is how old the news is that a copy works with. Damping is set so that this age can do no harm.",task:"Choose a link to see both its ends.",where:"#network",sees:"#link",tab:"network",done:i=>i.link.get()!==null},{title:"Cut it",words:"Networks fail. When news stays away, both ends let go of their spring without a kick, and everybody else goes on.",task:"Press Cut, and watch the line and the verdict on top.",where:"#link, #network",sees:"#network, #verdict",tab:"network",needs:Il("cut","Links cannot be cut from here; go on with →."),done:i=>fd(i).length>0},{title:"Mend it",words:"When news comes again, the ends first catch up and save energy, and couple only when both can pay for it.",task:"Press Mend, and wait until the link is coupled again.",where:"#link, #network",sees:"#network, #verdict",tab:"network",needs:(i,e)=>Et(i,"cut")?fd(i).length||e.cut?null:"No link is cut. Go back with ← to cut one, or on with →.":"Links cannot be mended from here; go on with →.",done:(i,e)=>{let{state:t}=i.store,n=e.cut??=[];for(let s of fd(i))n.some(([r,o])=>r===s[0]&&o===s[1])||n.push(s);return n.length>0&&n.every(([s,r])=>qs(t,s,r)==="coupled")}},{title:"Join them badly",words:"Over which links users are joined matters. With the worst choice of as many links copies agree late; with the best, soonest.",task:"Choose Worst, drag and let go; then choose Best.",where:"#topology",sees:"#stage, #network",tab:"network",needs:Il("links","Links are not chosen here; go on with →."),done:({store:i},e)=>{let{state:t}=i;if(!t)return!1;let n=dd(t.links);return t.choices.worst&&dd(t.choices.worst)===n&&(e.worst=!0),!!e.worst&&!!t.choices.best&&dd(t.choices.best)===n}},{title:"Follow the energy",words:"Every joule is booked: put in by hands, added by delays, damped, or still in the copies. Both bars are equally long, always.",task:"Drag the object, and see what you put in.",where:"#energy",sees:"#stage",tab:"energy",done:(i,e)=>{let t=Object.values(i.store.state?.members??{}).reduce((s,r)=>s+Math.abs(r.supplied??0),0),n=e.first??=t;return i.tab.get()==="energy"&&(Math.abs(t-n)>1e-6||!Et(i,"hand"))}},{title:"Take the guarantee away",words:"Below the damping that delays ask for, nothing keeps energy from growing. See it once: after some seconds a copy runs away, is caught, and all damping is back.",task:"Lower the damping and watch. Restore it, or wait until it comes back by itself.",where:i=>i.lowered?"#stage-frame":"#margin",sees:"#stage-frame, #margin",tab:"margin",needs:Il("damping","Damping is not changed from here; this was the last step."),done:({store:i},e)=>{let t=i.state?.damping??1;return t<1&&(e.lowered=!0),!!e.lowered&&t===1}}];function Xb(){try{let{step:i=0,over:e=!1}=JSON.parse(localStorage.getItem(md)??"{}");return{step:Math.min(Math.max(Math.floor(Number(i))||0,0),Ui.length-1),over:e===!0}}catch{return{step:0,over:!1}}}function pd(i,e){try{localStorage.setItem(md,JSON.stringify({step:i,over:e}))}catch{}}function t0(i,e){let t=0,n={},s=!1,r=new Set,o=O("div",{class:"tour-hole",hidden:!0,"aria-hidden":"true"}),a=O("p",{class:"tour-number tabular"}),l=O("h2",{id:"tour-title"}),c=O("p",{id:"tour-words"}),h=vn("play",16),u=O("span",null),d=O("p",{class:"tour-task",role:"status"},h,u),m=O("div",{class:"tour-dots","aria-hidden":"true"},...Ui.map(()=>O("i"))),g=$e("Back",()=>w(t-1),{class:"button small",label:"Step before (←)"}),y=$e("Next",()=>t+1<Ui.length?w(t+1):N(!0),{class:"button small",label:"Next step (→)",id:"tour-next"}),p=$e("",()=>N(!1),{icon:"close",class:"button bare",label:"Leave the tour (Esc); it can be taken up again"}),f=O("div",{class:"tour-card",id:"tour",role:"dialog","aria-modal":"false","aria-labelledby":"tour-title","aria-describedby":"tour-words",tabindex:-1,hidden:!0},O("div",{class:"panel-head"},a,O("div",{class:"grow"}),p),l,c,d,O("div",{class:"tour-foot"},m,O("div",{class:"grow"}),g,y)),v=$e("Start",()=>F(),{class:"button small primary"}),M=$e("Not now",()=>{dt(b,!1),pd(t,!0)},{class:"button small"}),b=O("div",{class:"tour-offer",id:"tour-offer",role:"region","aria-label":"Tour",hidden:!0},vn("tour",18),O("span",null,"New here? Two minutes show you everything."),v,M);e.append(o,f,b);let E=R=>R?R.split(", ").flatMap(U=>[...document.querySelector(U)?.getClientRects()??[]]):[],T=()=>{let R=Ui[t];if(!s||!R)return;let U=E(typeof R.where=="string"?R.where:R.where(n))[0];if(o.hidden=!U,!U)return;let k=4,[I,H]=[Math.max(U.left-k,2),Math.max(U.top-k,2)];Object.assign(o.style,{left:`${I}px`,top:`${H}px`,width:`${Math.min(U.right+k,innerWidth-2)-I}px`,height:`${Math.min(U.bottom+k,innerHeight-2)-H}px`});let Y={left:8,top:8,width:innerWidth-16,height:innerHeight-16},{width:W,height:le}=f.getBoundingClientRect(),Z=jg({width:W,height:le},[U,...E(R.sees??Hb),...E(".bar")],Y);f.style.left=`${Z.left}px`,f.style.top=`${Z.top}px`},x=()=>{let R=Ui[t];if(!s||!R)return;let U=R.needs?.(i,n)??null;!r.has(t)&&U===null&&R.done(i,n)&&(r=new Set([...r,t]),i.say(t+1<Ui.length?"Done. Go on when you like.":"That was everything.","good"));let k=r.has(t);Ge(f,"data-done",k?"":null),On(h,k?"tick":U?"wait":"play"),Le(u,U??R.task),Ge(y,"class",`button small${k?" primary":""}`),Le(y.lastElementChild??y,t+1===Ui.length?"Finish":k?"Next":"Skip"),T()},w=R=>{t=Math.min(Math.max(R,0),Ui.length-1);let U=Ui[t];U&&(n={},pd(t,!1),U.tab&&i.tab.set(U.tab),Le(a,`Step ${t+1} of ${Ui.length}`),Le(l,U.title),Le(c,U.words),g.disabled=t===0,[...m.children].forEach((k,I)=>Ge(k,"class",I===t?"here":r.has(I)?"done":null)),x())},F=()=>{s=!0,dt(b,!1),f.hidden=!1,w(Xb().step),f.focus({preventScroll:!0})},N=R=>{s=!1,f.hidden=o.hidden=!0,pd(R?0:t,!0),R?r=new Set:i.say(`You can take the tour up again at step ${t+1}.`),document.getElementById("tour-open")?.focus()};return document.addEventListener("keydown",R=>{if(!s||document.querySelector("dialog[open]"))return;let U=f.contains(document.activeElement)||document.activeElement===document.body;if(R.key==="Escape"&&U&&!Js(i))N(!1);else if(R.key==="ArrowRight"&&U&&!Js(i))t+1<Ui.length?w(t+1):N(!0);else if(R.key==="ArrowLeft"&&U&&!Js(i))w(t-1);else return;R.preventDefault(),R.stopPropagation()},!0),addEventListener("resize",T),setInterval(x,Wb),{open:F,invite:()=>{let R=!1;try{R=localStorage.getItem(md)===null}catch{}R&&!s&&dt(b,!0)}}}var qb={users:"Users",network:"Network",plots:"Plots",energy:"Energy",margin:"Margin",events:"Events"},n0=4500;function $b(){let i=vn("good",16),e=O("span",null),t=O("div",{class:"toast",hidden:!0,"aria-hidden":"true"},i,e),n=O("div",{class:"unseen",role:"status","aria-live":"polite",id:"spoken"}),s=0;return{element:O("div",{class:"toasts"},t,n),say(r,o="info"){let a=r.slice(0,1).toUpperCase()+r.slice(1);Le(e,a),Le(n,a),Ge(t,"data-level",o),On(i,o==="info"?"wait":o),t.hidden=!1,clearTimeout(s),s=window.setTimeout(()=>t.hidden=!0,o==="bad"?2*n0:n0)}}}function Yb(i){let e=Pp.map(s=>{let r=O("button",{type:"button",role:"tab",id:`tab-${s}`,"aria-controls":s,"data-tab":s},qb[s]);return r.addEventListener("click",()=>i.tab.set(s)),r}),t=O("div",{class:"tabs",role:"tablist","aria-label":"Instruments"},...e);t.addEventListener("keydown",s=>{let r={ArrowRight:1,ArrowLeft:-1}[s.key];if(!r)return;let o=e.filter(c=>c.getClientRects().length),a=o.indexOf(document.activeElement),l=o[(a+r+o.length)%o.length];l?.focus(),l?.dataset.tab&&i.tab.set(l.dataset.tab),s.preventDefault(),s.stopPropagation()});let n=()=>{let s=i.tab.get();document.documentElement.dataset.tab=s;let r=["energy","margin","events"].includes(s);document.documentElement.dataset.side=r?s:document.documentElement.dataset.side??"energy";let o=matchMedia("(max-width: 899px)").matches?s:document.documentElement.dataset.side;for(let a of e)Ge(a,"aria-selected",String(a.dataset.tab===o)),a.tabIndex=a.dataset.tab===o?0:-1};return i.tab.on(n),matchMedia("(max-width: 899px)").addEventListener("change",n),n(),t}function Jb(i,e,t){let n=s=>{let r=i.aiming.get();if(!r||!e.contains(s.target)||(s.preventDefault(),s.stopImmediatePropagation(),s.type!=="pointerdown"))return;let o=t()?.aim(s.clientX,s.clientY)??null;if(!o)return i.say("There is nothing of the object there; click nearer to it.","warn");i.aiming.set(null);let a=i.store.frame?.copies.find(c=>c.slot===r.slot)?.node??-1,l=a>=0?a:i.store.scene?.skin?.node[o.point]??o.point;i.act({what:"hand",slot:r.slot,mode:"pull",node:l,to:o.to})};for(let s of["pointerdown","pointermove","pointerup"])addEventListener(s,n,!0);addEventListener("keydown",s=>{s.key!=="Escape"||s.defaultPrevented||(i.aiming.get()?i.aiming.set(null):document.querySelector("dialog[open]")||i.link.set(null))}),i.aiming.on(s=>e.toggleAttribute("data-aiming",s!==null))}function Zb(i){let e=-1/0,t="";i.store.on("state",()=>{let n=i.store.state;if(!n)return;let s=n.events.at(-1);s&&s.time>e&&(e>-1/0&&Le(document.getElementById("spoken")??document.createElement("i"),s.text),e=s.time),t&&t!==n.verdict.level&&Le(document.getElementById("spoken")??document.createElement("i"),n.verdict.text),t=n.verdict.level}),i.store.on("scene",()=>{i.store.state||([e,t]=[-1/0,""])})}function i0(i,e,t){let n=$b(),s={store:e,connection:t,link:new mr(null),opened:new mr(null),tab:new mr("energy"),aiming:new mr(null),say:n.say,async act(p,f=!1){let v=await t.do(p);return(!v.ok||!f)&&n.say(v.text||(v.ok?"Done.":"It was refused."),v.ok?"good":"bad"),v.ok}},r=null,o=O("div",{id:"stage"}),a=()=>r?.reset(),l=$p(s),c=t0(s,i),h=Yg(s),u=kp(s,{tour:c.open,invite:l.open,keys:()=>d.open()}),d=Kp(s,{tour:c.open,invite:l.open,record:u.record,freeze:h.freeze,reset:a}),m=O("main",{class:"layout"},Jp(s),O("div",{id:"stage-frame"},o,Kg(s,a),cm(s),O("div",{class:"notices"},n.element,Up(s))),h.element,lm(s),Yb(s),Gp(s),Xg(s),Hp(s)),g=$e("To the object",()=>o.querySelector(".ct-canvas")?.focus(),{class:"skip"});i.classList.add("shell"),i.prepend(g,u.element,m),matchMedia("(max-width: 899px)").matches&&s.tab.set("users"),s.opened.on(p=>p!==null&&r?.pulse(p)),Jb(s,o,()=>r),Zb(s),Zg(i);let y=e.on("scene",()=>{y(),c.invite()});return{stageElement:o,attach:p=>r=p}}function gd(i,e,t){let n=i.emulated[`${e}-${t}`];if(n?.cut)return null;if(n&&n.delay+n.jitter>0)return n.delay+n.jitter;let s=i.ends[`${e}-${t}`];return s?.ages!=null?s.ages/2:s?.round_trip!=null?s.round_trip/2:n?n.delay:null}function Ll(i,e){let t=new Map([[e,0]]),n=new Set;for(;;){let s=-1;for(let[r,o]of t)!n.has(r)&&(s<0||o<t.get(s))&&(s=r);if(s<0)return t;n.add(s);for(let[r,o]of i.links){if(r!==s&&o!==s)continue;let a=r===s?o:r,l=gd(i,a,s);if(l===null)continue;let c=t.get(s)+l;c<(t.get(a)??1/0)&&t.set(a,c)}}}function ss(i){return i<.9995?`${Math.round(i*1e3)} ms`:`${i.toFixed(1)} s`}function Nl(i,e=i){let t=Math.abs(e),[n,s]=t<95e-5?[1e6,"µm"]:t<.095?[1e3,"mm"]:t<.95?[100,"cm"]:[1,"m"],r=i*n;return`${r.toFixed(Math.abs(r)<9.95&&r!==Math.round(r)?1:0).replace("-","−")} ${s}`}function Dl(i){return`${i.toFixed(i<.995?2:i<9.95?1:0)} N`}function ao(i){let e=10**Math.floor(Math.log10(Math.max(i,1e-12)));for(let t of[1,2,5,10])if(t*e>=i*.9999)return t*e;return 10*e}var yd={displacement:"displacement",stress:"stretch",plain:""},[Kb,jb]=[440,220],lo=class{root=document.createElement("div");key=document.createElement("figure");what=document.createElement("figcaption");most=document.createElement("span");hint=document.createElement("p");lines=document.createElement("div");off;constructor(e,t,n){this.root.className="ct-furniture",this.key.className="ct-legend";let s=document.createElement("i");s.style.background=`linear-gradient(to right, ${il.join(", ")})`;let r=document.createElement("span");r.textContent="0",this.key.append(this.what,r,s,this.most),this.hint.className="ct-hint",this.hint.textContent=t.scene?.acts?n.act:n.look,this.hint.hidden=!this.hint.textContent,this.lines.className="ct-lines",this.root.append(this.lines,this.key,this.hint),e.append(this.root),this.off=t.on("frame",()=>{let o=t.frame?.copies.find(a=>a.slot===t.slot)?.mode;(o==="grab"||o==="ball")&&this.told()})}told(){this.hint.hidden=!0,this.off()}legend(e,t){this.key.hidden=!yd[e],this.what.textContent!==yd[e]&&(this.what.textContent=yd[e]),this.most.textContent!==t&&(this.most.textContent=t)}covered(e,t,n){let s=Math.min(Kb/2,.44*n);return!this.hint.hidden&&e<n/2+s&&t>n/2-s?94:!this.key.hidden&&t>n-jb?44:0}rules(e){this.lines.replaceChildren(...e.map(({x:t,y:n,width:s,height:r})=>{let o=document.createElement("i");return Object.assign(o.style,{left:`${t}px`,top:`${n}px`,width:`${s}px`,height:`${r}px`}),o}))}dispose(){this.off(),this.root.remove()}};var Qb=[[148,158,172],[232,160,30],[208,48,42]],eM=[[122,133,150],[245,185,66],[255,107,91]];function pa(i,e){let t=e?eM:Qb,n=Math.min(Math.max(i,0),1)/.4,s=n<1?0:1;return`#${t[s].map((o,a)=>Math.round(o+(t[s+1][a]-o)*(s?(n-1)/1.5:n))).map(o=>o.toString(16).padStart(2,"0")).join("")}`}var co=class{held=!1;told=0;read(){let e=this.first();if(!e)return null;let t=!!e.buttons[0]?.pressed,n={x:e.axes[0]??0,y:e.axes[1]??0,depth:-(e.axes[3]??0),pressed:t&&!this.held,released:!t&&this.held};return this.held=t,n}rumble(e){let t=performance.now(),n=this.first()?.vibrationActuator;if(!n||t-this.told<90||e<.03)return;this.told=t;let s=Math.min(e,1);n.playEffect("dual-rumble",{duration:90*1.5,strongMagnitude:s**2,weakMagnitude:s}).catch(()=>{})}first(){try{return navigator.getGamepads?.().find(e=>e?.connected)??null}catch{return null}}};var I0=0,$d=1,L0=2;var Oa=1,N0=2,Fo=3,hr=0,ti=1,ls=2,Pr=0,Oo=1,Yd=2,Jd=3,Zd=4,D0=5;var Ir=100,U0=101,F0=102,O0=103,k0=104,B0=200,z0=201,V0=202,G0=203,Kd=204,jd=205,H0=206,W0=207,X0=208,q0=209,$0=210,Y0=211,J0=212,Z0=213,K0=214,uc=0,dc=1,fc=2,Eo=3,pc=4,mc=5,To=6,gc=7,Qd=0,j0=1,Q0=2,cs=0,ef=1,tf=2,nf=3,sf=4,rf=5,of=6,af=7;var lf=300,Lr=301,ko=302,Xc=303,qc=304,yc=1e3,os=1001,vc=1002,Pn=1003,ey=1004;var ka=1005;var Dn=1006,$c=1007;var Bi=1008;var yi=1009,cf=1010,hf=1011,Bo=1012,Yc=1013,zi=1014,Vi=1015,Gi=1016,Jc=1017,Zc=1018,Nr=1020,uf=35902,df=35899,ff=1021,pf=1022,Hi=1023,Ts=1026,Is=1027,mf=1028,Kc=1029,ur=1030,jc=1031;var Qc=1033,Ba=33776,za=33777,Va=33778,Ga=33779,eh=35840,th=35841,nh=35842,ih=35843,sh=36196,rh=37492,oh=37496,ah=37488,lh=37489,Ha=37490,ch=37491,hh=37808,uh=37809,dh=37810,fh=37811,ph=37812,mh=37813,gh=37814,yh=37815,vh=37816,xh=37817,_h=37818,bh=37819,Mh=37820,Sh=37821,wh=36492,Eh=36494,Th=36495,Ah=36283,Ch=36284,Wa=36285,Rh=36286;var ba=2300,xc=2301,lc=2302,zd=2303,Vd=2400,Gd=2401,Hd=2402;var ty=3200;var gf=0,ny=1,Ls="",pi="srgb",Ma="srgb-linear",Sa="linear",Pt="srgb";var cc=7680;var iy=519,sy=512,ry=513,oy=514,yf=515,ay=516,ly=517,vf=518,xf=519,cy=35044,Ph=35048;var _f="300 es",Ti=2e3,wa=2001;function tM(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function nM(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Ea(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function hy(){let i=Ea("canvas");return i.style.display="block",i}var s0={},Ao=null;function bf(...i){let e="THREE."+i.shift();Ao?Ao("log",e,...i):console.log(e,...i)}function uy(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Ze(...i){i=uy(i);let e="THREE."+i.shift();if(Ao)Ao("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function tt(...i){i=uy(i);let e="THREE."+i.shift();if(Ao)Ao("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function _a(...i){let e=i.join(" ");e in s0||(s0[e]=!0,Ze(...i))}function dy(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var fy={[uc]:uc,[fc]:To,[pc]:pc,[Eo]:mc,[dc]:dc,[To]:fc,[gc]:gc,[mc]:Eo},as=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Bn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var hc=Math.PI/180,_c=180/Math.PI;function Xa(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Bn[i&255]+Bn[i>>8&255]+Bn[i>>16&255]+Bn[i>>24&255]+"-"+Bn[e&255]+Bn[e>>8&255]+"-"+Bn[e>>16&15|64]+Bn[e>>24&255]+"-"+Bn[t&63|128]+Bn[t>>8&255]+"-"+Bn[t>>16&255]+Bn[t>>24&255]+Bn[n&255]+Bn[n>>8&255]+Bn[n>>16&255]+Bn[n>>24&255]).toLowerCase()}function xt(i,e,t){return Math.max(e,Math.min(t,i))}function iM(i,e){return(i%e+e)%e}function vd(i,e,t){return(1-t)*i+t*e}function py(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Mf(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function sM(i,e){if(e.constructor===Float32Array)return i;let t=Mf(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function rM(i,e){if(e.constructor===Float32Array)return i;let t=Mf(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var _t=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=xt(this.x,e.x,t.x),this.y=xt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=xt(this.x,e,t),this.y=xt(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(xt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(xt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Gn=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],d=r[o+0],m=r[o+1],g=r[o+2],y=r[o+3];if(u!==y||l!==d||c!==m||h!==g){let p=l*d+c*m+h*g+u*y;p<0&&(d=-d,m=-m,g=-g,y=-y,p=-p);let f=1-a;if(p<.9995){let v=Math.acos(p),M=Math.sin(v);f=Math.sin(f*v)/M,a=Math.sin(a*v)/M,l=l*f+d*a,c=c*f+m*a,h=h*f+g*a,u=u*f+y*a}else{l=l*f+d*a,c=c*f+m*a,h=h*f+g*a,u=u*f+y*a;let v=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=v,c*=v,h*=v,u*=v}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],d=r[o+1],m=r[o+2],g=r[o+3];return e[t]=a*g+h*u+l*m-c*d,e[t+1]=l*g+h*d+c*u-a*m,e[t+2]=c*g+h*m+a*d-l*u,e[t+3]=h*g-a*u-l*d-c*m,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),d=l(n/2),m=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*m*g,this._y=c*m*u-d*h*g,this._z=c*h*g+d*m*u,this._w=c*h*u-d*m*g;break;case"YXZ":this._x=d*h*u+c*m*g,this._y=c*m*u-d*h*g,this._z=c*h*g-d*m*u,this._w=c*h*u+d*m*g;break;case"ZXY":this._x=d*h*u-c*m*g,this._y=c*m*u+d*h*g,this._z=c*h*g+d*m*u,this._w=c*h*u-d*m*g;break;case"ZYX":this._x=d*h*u-c*m*g,this._y=c*m*u+d*h*g,this._z=c*h*g-d*m*u,this._w=c*h*u+d*m*g;break;case"YZX":this._x=d*h*u+c*m*g,this._y=c*m*u+d*h*g,this._z=c*h*g-d*m*u,this._w=c*h*u-d*m*g;break;case"XZY":this._x=d*h*u-c*m*g,this._y=c*m*u-d*h*g,this._z=c*h*g+d*m*u,this._w=c*h*u+d*m*g;break;default:Ze("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],u=t[10],d=n+a+u;if(d>0){let m=.5/Math.sqrt(d+1);this._w=.25/m,this._x=(h-l)*m,this._y=(r-c)*m,this._z=(o-s)*m}else if(n>a&&n>u){let m=2*Math.sqrt(1+n-a-u);this._w=(h-l)/m,this._x=.25*m,this._y=(s+o)/m,this._z=(r+c)/m}else if(a>u){let m=2*Math.sqrt(1+a-n-u);this._w=(r-c)/m,this._x=(s+o)/m,this._y=.25*m,this._z=(l+h)/m}else{let m=2*Math.sqrt(1+u-n-a);this._w=(o-s)/m,this._x=(r+c)/m,this._y=(l+h)/m,this._z=.25*m}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(xt(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},V=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(r0.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(r0.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),h=2*(a*t-r*s),u=2*(r*n-o*t);return this.x=t+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=xt(this.x,e.x,t.x),this.y=xt(this.y,e.y,t.y),this.z=xt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=xt(this.x,e,t),this.y=xt(this.y,e,t),this.z=xt(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(xt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return xd.copy(this).projectOnVector(e),this.sub(xd)}reflect(e){return this.sub(xd.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(xt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},xd=new V,r0=new Gn,nt=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],m=n[5],g=n[8],y=s[0],p=s[3],f=s[6],v=s[1],M=s[4],b=s[7],E=s[2],T=s[5],x=s[8];return r[0]=o*y+a*v+l*E,r[3]=o*p+a*M+l*T,r[6]=o*f+a*b+l*x,r[1]=c*y+h*v+u*E,r[4]=c*p+h*M+u*T,r[7]=c*f+h*b+u*x,r[2]=d*y+m*v+g*E,r[5]=d*p+m*M+g*T,r[8]=d*f+m*b+g*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=h*o-a*c,d=a*l-h*r,m=c*r-o*l,g=t*u+n*d+s*m;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/g;return e[0]=u*y,e[1]=(s*c-h*n)*y,e[2]=(a*n-s*o)*y,e[3]=d*y,e[4]=(h*t-s*l)*y,e[5]=(s*r-a*t)*y,e[6]=m*y,e[7]=(n*l-c*t)*y,e[8]=(o*t-n*r)*y,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return _a("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(_d.makeScale(e,t)),this}rotate(e){return _a("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(_d.makeRotation(-e)),this}translate(e,t){return _a("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(_d.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},_d=new nt,o0=new nt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),a0=new nt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function oM(){let i={enabled:!0,workingColorSpace:Ma,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Pt&&(s.r=Es(s.r),s.g=Es(s.g),s.b=Es(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Pt&&(s.r=wo(s.r),s.g=wo(s.g),s.b=wo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ls?Sa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Ma]:{primaries:e,whitePoint:n,transfer:Sa,toXYZ:o0,fromXYZ:a0,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:pi},outputColorSpaceConfig:{drawingBufferColorSpace:pi}},[pi]:{primaries:e,whitePoint:n,transfer:Pt,toXYZ:o0,fromXYZ:a0,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:pi}}}),i}var vt=oM();function Es(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function wo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var ho,bc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{ho===void 0&&(ho=Ea("canvas")),ho.width=e.width,ho.height=e.height;let s=ho.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=ho}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Ea("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Es(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Es(t[n]/255)*255):t[n]=Es(t[n]);return{data:t,width:e.width,height:e.height}}else return Ze("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},aM=0,Co=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:aM++}),this.uuid=Xa(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(bd(s[o].image)):r.push(bd(s[o]))}else r=bd(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function bd(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?bc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Ze("Texture: Unable to serialize Texture."),{})}var lM=0,Md=new V,ni=class i extends as{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=os,s=os,r=Dn,o=Bi,a=Hi,l=yi,c=i.DEFAULT_ANISOTROPY,h=Ls){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:lM++}),this.uuid=Xa(),this.name="",this.source=new Co(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new _t(0,0),this.repeat=new _t(1,1),this.center=new _t(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new nt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Md).x}get height(){return this.source.getSize(Md).y}get depth(){return this.source.getSize(Md).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){Ze(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ze(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==lf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case yc:e.x=e.x-Math.floor(e.x);break;case os:e.x=e.x<0?0:1;break;case vc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case yc:e.y=e.y-Math.floor(e.y);break;case os:e.y=e.y<0?0:1;break;case vc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ni.DEFAULT_IMAGE=null;ni.DEFAULT_MAPPING=lf;ni.DEFAULT_ANISOTROPY=1;var Qt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],h=l[4],u=l[8],d=l[1],m=l[5],g=l[9],y=l[2],p=l[6],f=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-y)<.01&&Math.abs(g-p)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+y)<.1&&Math.abs(g+p)<.1&&Math.abs(c+m+f-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let M=(c+1)/2,b=(m+1)/2,E=(f+1)/2,T=(h+d)/4,x=(u+y)/4,w=(g+p)/4;return M>b&&M>E?M<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(M),s=T/n,r=x/n):b>E?b<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),n=T/s,r=w/s):E<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(E),n=x/r,s=w/r),this.set(n,s,r,t),this}let v=Math.sqrt((p-g)*(p-g)+(u-y)*(u-y)+(d-h)*(d-h));return Math.abs(v)<.001&&(v=1),this.x=(p-g)/v,this.y=(u-y)/v,this.z=(d-h)/v,this.w=Math.acos((c+m+f-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=xt(this.x,e.x,t.x),this.y=xt(this.y,e.y,t.y),this.z=xt(this.z,e.z,t.z),this.w=xt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=xt(this.x,e,t),this.y=xt(this.y,e,t),this.z=xt(this.z,e,t),this.w=xt(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(xt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Mc=class extends as{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Dn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new Qt(0,0,e,t),this.scissorTest=!1,this.viewport=new Qt(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new ni({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Dn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Co(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},ei=class extends Mc{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},Ta=class extends ni{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Pn,this.minFilter=Pn,this.wrapR=os,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Sc=class extends ni{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Pn,this.minFilter=Pn,this.wrapR=os,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var zt=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,l,c,h,u,d,m,g,y,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,h,u,d,m,g,y,p)}set(e,t,n,s,r,o,a,l,c,h,u,d,m,g,y,p){let f=this.elements;return f[0]=e,f[4]=t,f[8]=n,f[12]=s,f[1]=r,f[5]=o,f[9]=a,f[13]=l,f[2]=c,f[6]=h,f[10]=u,f[14]=d,f[3]=m,f[7]=g,f[11]=y,f[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/uo.setFromMatrixColumn(e,0).length(),r=1/uo.setFromMatrixColumn(e,1).length(),o=1/uo.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(e.order==="XYZ"){let d=o*h,m=o*u,g=a*h,y=a*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=m+g*c,t[5]=d-y*c,t[9]=-a*l,t[2]=y-d*c,t[6]=g+m*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*h,m=l*u,g=c*h,y=c*u;t[0]=d+y*a,t[4]=g*a-m,t[8]=o*c,t[1]=o*u,t[5]=o*h,t[9]=-a,t[2]=m*a-g,t[6]=y+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*h,m=l*u,g=c*h,y=c*u;t[0]=d-y*a,t[4]=-o*u,t[8]=g+m*a,t[1]=m+g*a,t[5]=o*h,t[9]=y-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*h,m=o*u,g=a*h,y=a*u;t[0]=l*h,t[4]=g*c-m,t[8]=d*c+y,t[1]=l*u,t[5]=y*c+d,t[9]=m*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,m=o*c,g=a*l,y=a*c;t[0]=l*h,t[4]=y-d*u,t[8]=g*u+m,t[1]=u,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=m*u+g,t[10]=d-y*u}else if(e.order==="XZY"){let d=o*l,m=o*c,g=a*l,y=a*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=d*u+y,t[5]=o*h,t[9]=m*u-g,t[2]=g*u-m,t[6]=a*h,t[10]=y*u+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(cM,e,hM)}lookAt(e,t,n){let s=this.elements;return di.subVectors(e,t),di.lengthSq()===0&&(di.z=1),di.normalize(),Zs.crossVectors(n,di),Zs.lengthSq()===0&&(Math.abs(n.z)===1?di.x+=1e-4:di.z+=1e-4,di.normalize(),Zs.crossVectors(n,di)),Zs.normalize(),Ul.crossVectors(di,Zs),s[0]=Zs.x,s[4]=Ul.x,s[8]=di.x,s[1]=Zs.y,s[5]=Ul.y,s[9]=di.y,s[2]=Zs.z,s[6]=Ul.z,s[10]=di.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],m=n[13],g=n[2],y=n[6],p=n[10],f=n[14],v=n[3],M=n[7],b=n[11],E=n[15],T=s[0],x=s[4],w=s[8],F=s[12],N=s[1],R=s[5],U=s[9],k=s[13],I=s[2],H=s[6],Y=s[10],W=s[14],le=s[3],Z=s[7],q=s[11],te=s[15];return r[0]=o*T+a*N+l*I+c*le,r[4]=o*x+a*R+l*H+c*Z,r[8]=o*w+a*U+l*Y+c*q,r[12]=o*F+a*k+l*W+c*te,r[1]=h*T+u*N+d*I+m*le,r[5]=h*x+u*R+d*H+m*Z,r[9]=h*w+u*U+d*Y+m*q,r[13]=h*F+u*k+d*W+m*te,r[2]=g*T+y*N+p*I+f*le,r[6]=g*x+y*R+p*H+f*Z,r[10]=g*w+y*U+p*Y+f*q,r[14]=g*F+y*k+p*W+f*te,r[3]=v*T+M*N+b*I+E*le,r[7]=v*x+M*R+b*H+E*Z,r[11]=v*w+M*U+b*Y+E*q,r[15]=v*F+M*k+b*W+E*te,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],u=e[6],d=e[10],m=e[14],g=e[3],y=e[7],p=e[11],f=e[15],v=l*m-c*d,M=a*m-c*u,b=a*d-l*u,E=o*m-c*h,T=o*d-l*h,x=o*u-a*h;return t*(y*v-p*M+f*b)-n*(g*v-p*E+f*T)+s*(g*M-y*E+f*x)-r*(g*b-y*T+p*x)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=e[9],d=e[10],m=e[11],g=e[12],y=e[13],p=e[14],f=e[15],v=t*a-n*o,M=t*l-s*o,b=t*c-r*o,E=n*l-s*a,T=n*c-r*a,x=s*c-r*l,w=h*y-u*g,F=h*p-d*g,N=h*f-m*g,R=u*p-d*y,U=u*f-m*y,k=d*f-m*p,I=v*k-M*U+b*R+E*N-T*F+x*w;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/I;return e[0]=(a*k-l*U+c*R)*H,e[1]=(s*U-n*k-r*R)*H,e[2]=(y*x-p*T+f*E)*H,e[3]=(d*T-u*x-m*E)*H,e[4]=(l*N-o*k-c*F)*H,e[5]=(t*k-s*N+r*F)*H,e[6]=(p*b-g*x-f*M)*H,e[7]=(h*x-d*b+m*M)*H,e[8]=(o*U-a*N+c*w)*H,e[9]=(n*N-t*U-r*w)*H,e[10]=(g*T-y*b+f*v)*H,e[11]=(u*b-h*T-m*v)*H,e[12]=(a*F-o*R-l*w)*H,e[13]=(t*R-n*F+s*w)*H,e[14]=(y*M-g*E-p*v)*H,e[15]=(h*E-u*M+d*v)*H,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,h=o+o,u=a+a,d=r*c,m=r*h,g=r*u,y=o*h,p=o*u,f=a*u,v=l*c,M=l*h,b=l*u,E=n.x,T=n.y,x=n.z;return s[0]=(1-(y+f))*E,s[1]=(m+b)*E,s[2]=(g-M)*E,s[3]=0,s[4]=(m-b)*T,s[5]=(1-(d+f))*T,s[6]=(p+v)*T,s[7]=0,s[8]=(g+M)*x,s[9]=(p-v)*x,s[10]=(1-(d+y))*x,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=uo.set(s[0],s[1],s[2]).length(),a=uo.set(s[4],s[5],s[6]).length(),l=uo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Fi.copy(this);let c=1/o,h=1/a,u=1/l;return Fi.elements[0]*=c,Fi.elements[1]*=c,Fi.elements[2]*=c,Fi.elements[4]*=h,Fi.elements[5]*=h,Fi.elements[6]*=h,Fi.elements[8]*=u,Fi.elements[9]*=u,Fi.elements[10]*=u,t.setFromRotationMatrix(Fi),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,s,r,o,a=Ti,l=!1){let c=this.elements,h=2*r/(t-e),u=2*r/(n-s),d=(t+e)/(t-e),m=(n+s)/(n-s),g,y;if(l)g=r/(o-r),y=o*r/(o-r);else if(a===Ti)g=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===wa)g=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=m,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=Ti,l=!1){let c=this.elements,h=2/(t-e),u=2/(n-s),d=-(t+e)/(t-e),m=-(n+s)/(n-s),g,y;if(l)g=1/(o-r),y=o/(o-r);else if(a===Ti)g=-2/(o-r),y=-(o+r)/(o-r);else if(a===wa)g=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=m,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},uo=new V,Fi=new zt,cM=new V(0,0,0),hM=new V(1,1,1),Zs=new V,Ul=new V,di=new V,l0=new zt,c0=new Gn,tr=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],m=s[10];switch(t){case"XYZ":this._y=Math.asin(xt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,m),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-xt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,m),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(xt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,m),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-xt(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,m),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(xt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,m));break;case"XZY":this._z=Math.asin(-xt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,m),this._y=0);break;default:Ze("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return l0.makeRotationFromQuaternion(e),this.setFromRotationMatrix(l0,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return c0.setFromEuler(this),this.setFromQuaternion(c0,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};tr.DEFAULT_ORDER="XYZ";var Aa=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},uM=0,h0=new V,fo=new Gn,xs=new zt,Fl=new V,ma=new V,dM=new V,fM=new Gn,u0=new V(1,0,0),d0=new V(0,1,0),f0=new V(0,0,1),p0={type:"added"},pM={type:"removed"},po={type:"childadded",child:null},Sd={type:"childremoved",child:null},ii=class i extends as{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:uM++}),this.uuid=Xa(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new V,t=new tr,n=new Gn,s=new V(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new zt},normalMatrix:{value:new nt}}),this.matrix=new zt,this.matrixWorld=new zt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Aa,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return fo.setFromAxisAngle(e,t),this.quaternion.multiply(fo),this}rotateOnWorldAxis(e,t){return fo.setFromAxisAngle(e,t),this.quaternion.premultiply(fo),this}rotateX(e){return this.rotateOnAxis(u0,e)}rotateY(e){return this.rotateOnAxis(d0,e)}rotateZ(e){return this.rotateOnAxis(f0,e)}translateOnAxis(e,t){return h0.copy(e).applyQuaternion(this.quaternion),this.position.add(h0.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(u0,e)}translateY(e){return this.translateOnAxis(d0,e)}translateZ(e){return this.translateOnAxis(f0,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(xs.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Fl.copy(e):Fl.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),ma.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?xs.lookAt(ma,Fl,this.up):xs.lookAt(Fl,ma,this.up),this.quaternion.setFromRotationMatrix(xs),s&&(xs.extractRotation(s.matrixWorld),fo.setFromRotationMatrix(xs),this.quaternion.premultiply(fo.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(tt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(p0),po.child=e,this.dispatchEvent(po),po.child=null):tt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(pM),Sd.child=e,this.dispatchEvent(Sd),Sd.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),xs.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),xs.multiply(e.parent.matrixWorld)),e.applyMatrix4(xs),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(p0),po.child=e,this.dispatchEvent(po),po.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ma,e,dM),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ma,fM,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(e.shapes,u)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),u=o(e.shapes),d=o(e.skeletons),m=o(e.animations),g=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),m.length>0&&(n.animations=m),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};ii.DEFAULT_UP=new V(0,1,0);ii.DEFAULT_MATRIX_AUTO_UPDATE=!0;ii.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Qn=class extends ii{constructor(){super(),this.isGroup=!0,this.type="Group"}},mM={type:"move"},Ro=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Qn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Qn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new V,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new V),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Qn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new V,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new V,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let y of e.hand.values()){let p=t.getJointPose(y,n),f=this._getHandJoint(c,y);p!==null&&(f.matrix.fromArray(p.transform.matrix),f.matrix.decompose(f.position,f.quaternion,f.scale),f.matrixWorldNeedsUpdate=!0,f.jointRadius=p.radius),f.visible=p!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),m=.02,g=.005;c.inputState.pinching&&d>m+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=m-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(mM)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Qn;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},my={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ks={h:0,s:0,l:0},Ol={h:0,s:0,l:0};function wd(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var bt=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=pi){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,vt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=vt.workingColorSpace){return this.r=e,this.g=t,this.b=n,vt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=vt.workingColorSpace){if(e=iM(e,1),t=xt(t,0,1),n=xt(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=wd(o,r,e+1/3),this.g=wd(o,r,e),this.b=wd(o,r,e-1/3)}return vt.colorSpaceToWorking(this,s),this}setStyle(e,t=pi){function n(r){r!==void 0&&parseFloat(r)<1&&Ze("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ze("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ze("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=pi){let n=my[e.toLowerCase()];return n!==void 0?this.setHex(n,t):Ze("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Es(e.r),this.g=Es(e.g),this.b=Es(e.b),this}copyLinearToSRGB(e){return this.r=wo(e.r),this.g=wo(e.g),this.b=wo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=pi){return vt.workingToColorSpace(zn.copy(this),e),Math.round(xt(zn.r*255,0,255))*65536+Math.round(xt(zn.g*255,0,255))*256+Math.round(xt(zn.b*255,0,255))}getHexString(e=pi){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=vt.workingColorSpace){vt.workingToColorSpace(zn.copy(this),t);let n=zn.r,s=zn.g,r=zn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=vt.workingColorSpace){return vt.workingToColorSpace(zn.copy(this),t),e.r=zn.r,e.g=zn.g,e.b=zn.b,e}getStyle(e=pi){vt.workingToColorSpace(zn.copy(this),e);let t=zn.r,n=zn.g,s=zn.b;return e!==pi?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Ks),this.setHSL(Ks.h+e,Ks.s+t,Ks.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Ks),e.getHSL(Ol);let n=vd(Ks.h,Ol.h,t),s=vd(Ks.s,Ol.s,t),r=vd(Ks.l,Ol.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},zn=new bt;bt.NAMES=my;var Cr=class extends ii{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new tr,this.environmentIntensity=1,this.environmentRotation=new tr,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Oi=new V,_s=new V,Ed=new V,bs=new V,mo=new V,go=new V,m0=new V,Td=new V,Ad=new V,Cd=new V,Rd=new Qt,Pd=new Qt,Id=new Qt,ws=class i{constructor(e=new V,t=new V,n=new V){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Oi.subVectors(e,t),s.cross(Oi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Oi.subVectors(s,t),_s.subVectors(n,t),Ed.subVectors(e,t);let o=Oi.dot(Oi),a=Oi.dot(_s),l=Oi.dot(Ed),c=_s.dot(_s),h=_s.dot(Ed),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,m=(c*l-a*h)*d,g=(o*h-a*l)*d;return r.set(1-m-g,g,m)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,bs)===null?!1:bs.x>=0&&bs.y>=0&&bs.x+bs.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,bs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,bs.x),l.addScaledVector(o,bs.y),l.addScaledVector(a,bs.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return Rd.setScalar(0),Pd.setScalar(0),Id.setScalar(0),Rd.fromBufferAttribute(e,t),Pd.fromBufferAttribute(e,n),Id.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Rd,r.x),o.addScaledVector(Pd,r.y),o.addScaledVector(Id,r.z),o}static isFrontFacing(e,t,n,s){return Oi.subVectors(n,t),_s.subVectors(e,t),Oi.cross(_s).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Oi.subVectors(this.c,this.b),_s.subVectors(this.a,this.b),Oi.cross(_s).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;mo.subVectors(s,n),go.subVectors(r,n),Td.subVectors(e,n);let l=mo.dot(Td),c=go.dot(Td);if(l<=0&&c<=0)return t.copy(n);Ad.subVectors(e,s);let h=mo.dot(Ad),u=go.dot(Ad);if(h>=0&&u<=h)return t.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(n).addScaledVector(mo,o);Cd.subVectors(e,r);let m=mo.dot(Cd),g=go.dot(Cd);if(g>=0&&m<=g)return t.copy(r);let y=m*c-l*g;if(y<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(n).addScaledVector(go,a);let p=h*g-m*u;if(p<=0&&u-h>=0&&m-g>=0)return m0.subVectors(r,s),a=(u-h)/(u-h+(m-g)),t.copy(s).addScaledVector(m0,a);let f=1/(p+y+d);return o=y*f,a=d*f,t.copy(n).addScaledVector(mo,o).addScaledVector(go,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},nr=class{constructor(e=new V(1/0,1/0,1/0),t=new V(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(ki.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(ki.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=ki.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,ki):ki.fromBufferAttribute(r,o),ki.applyMatrix4(e.matrixWorld),this.expandByPoint(ki);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),kl.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),kl.copy(n.boundingBox)),kl.applyMatrix4(e.matrixWorld),this.union(kl)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,ki),ki.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(ga),Bl.subVectors(this.max,ga),yo.subVectors(e.a,ga),vo.subVectors(e.b,ga),xo.subVectors(e.c,ga),js.subVectors(vo,yo),Qs.subVectors(xo,vo),wr.subVectors(yo,xo);let t=[0,-js.z,js.y,0,-Qs.z,Qs.y,0,-wr.z,wr.y,js.z,0,-js.x,Qs.z,0,-Qs.x,wr.z,0,-wr.x,-js.y,js.x,0,-Qs.y,Qs.x,0,-wr.y,wr.x,0];return!Ld(t,yo,vo,xo,Bl)||(t=[1,0,0,0,1,0,0,0,1],!Ld(t,yo,vo,xo,Bl))?!1:(zl.crossVectors(js,Qs),t=[zl.x,zl.y,zl.z],Ld(t,yo,vo,xo,Bl))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,ki).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(ki).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Ms[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Ms[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Ms[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Ms[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Ms[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Ms[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Ms[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Ms[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Ms),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Ms=[new V,new V,new V,new V,new V,new V,new V,new V],ki=new V,kl=new nr,yo=new V,vo=new V,xo=new V,js=new V,Qs=new V,wr=new V,ga=new V,Bl=new V,zl=new V,Er=new V;function Ld(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Er.fromArray(i,r);let a=s.x*Math.abs(Er.x)+s.y*Math.abs(Er.y)+s.z*Math.abs(Er.z),l=e.dot(Er),c=t.dot(Er),h=n.dot(Er);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var mn=new V,Vl=new _t,gM=0,Vn=class extends as{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:gM++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=cy,this.updateRanges=[],this.gpuType=Vi,this.version=0,this._normalizationScale=e!==void 0?Mf(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Vl.fromBufferAttribute(this,t),Vl.applyMatrix3(e),this.setXY(t,Vl.x,Vl.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)mn.fromBufferAttribute(this,t),mn.applyMatrix3(e),this.setXYZ(t,mn.x,mn.y,mn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)mn.fromBufferAttribute(this,t),mn.applyMatrix4(e),this.setXYZ(t,mn.x,mn.y,mn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)mn.fromBufferAttribute(this,t),mn.applyNormalMatrix(e),this.setXYZ(t,mn.x,mn.y,mn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)mn.fromBufferAttribute(this,t),mn.transformDirection(e),this.setXYZ(t,mn.x,mn.y,mn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):sM(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):rM(e,this.array)}};var Ca=class extends Vn{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var Ra=class extends Vn{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var Zt=class extends Vn{constructor(e,t,n){super(new Float32Array(e),t,n)}},yM=new nr,ya=new V,Nd=new V,ir=class{constructor(e=new V,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):yM.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;ya.subVectors(e,this.center);let t=ya.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(ya,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Nd.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(ya.copy(e.center).add(Nd)),this.expandByPoint(ya.copy(e.center).sub(Nd))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},vM=0,Ei=new zt,Dd=new ii,_o=new V,fi=new nr,va=new nr,Rn=new V,In=class i extends as{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:vM++}),this.uuid=Xa(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(tM(e)?Ra:Ca)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new nt().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ei.makeRotationFromQuaternion(e),this.applyMatrix4(Ei),this}rotateX(e){return Ei.makeRotationX(e),this.applyMatrix4(Ei),this}rotateY(e){return Ei.makeRotationY(e),this.applyMatrix4(Ei),this}rotateZ(e){return Ei.makeRotationZ(e),this.applyMatrix4(Ei),this}translate(e,t,n){return Ei.makeTranslation(e,t,n),this.applyMatrix4(Ei),this}scale(e,t,n){return Ei.makeScale(e,t,n),this.applyMatrix4(Ei),this}lookAt(e){return Dd.lookAt(e),Dd.updateMatrix(),this.applyMatrix4(Dd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(_o).negate(),this.translate(_o.x,_o.y,_o.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Zt(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ze("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new nr);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){tt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new V(-1/0,-1/0,-1/0),new V(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];fi.setFromBufferAttribute(r),this.morphTargetsRelative?(Rn.addVectors(this.boundingBox.min,fi.min),this.boundingBox.expandByPoint(Rn),Rn.addVectors(this.boundingBox.max,fi.max),this.boundingBox.expandByPoint(Rn)):(this.boundingBox.expandByPoint(fi.min),this.boundingBox.expandByPoint(fi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&tt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ir);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){tt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new V,1/0);return}if(e){let n=this.boundingSphere.center;if(fi.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];va.setFromBufferAttribute(a),this.morphTargetsRelative?(Rn.addVectors(fi.min,va.min),fi.expandByPoint(Rn),Rn.addVectors(fi.max,va.max),fi.expandByPoint(Rn)):(fi.expandByPoint(va.min),fi.expandByPoint(va.max))}fi.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)Rn.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Rn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Rn.fromBufferAttribute(a,c),l&&(_o.fromBufferAttribute(e,c),Rn.add(_o)),s=Math.max(s,n.distanceToSquared(Rn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&tt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){tt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Vn(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let F=0;F<n.count;F++)a[F]=new V,l[F]=new V;let h=new V,u=new V,d=new V,m=new _t,g=new _t,y=new _t,p=new V,f=new V;function v(F,N,R){c[F]=c[N]=c[R]=1,h.fromBufferAttribute(n,F),u.fromBufferAttribute(n,N),d.fromBufferAttribute(n,R),m.fromBufferAttribute(r,F),g.fromBufferAttribute(r,N),y.fromBufferAttribute(r,R),u.sub(h),d.sub(h),g.sub(m),y.sub(m);let U=1/(g.x*y.y-y.x*g.y);isFinite(U)&&(p.copy(u).multiplyScalar(y.y).addScaledVector(d,-g.y).multiplyScalar(U),f.copy(d).multiplyScalar(g.x).addScaledVector(u,-y.x).multiplyScalar(U),a[F].add(p),a[N].add(p),a[R].add(p),l[F].add(f),l[N].add(f),l[R].add(f))}let M=this.groups;M.length===0&&(M=[{start:0,count:e.count}]);for(let F=0,N=M.length;F<N;++F){let R=M[F],U=R.start,k=R.count;for(let I=U,H=U+k;I<H;I+=3)v(e.getX(I+0),e.getX(I+1),e.getX(I+2))}let b=new V,E=new V,T=new V,x=new V;function w(F){T.fromBufferAttribute(s,F),x.copy(T);let N=a[F];b.copy(N),b.sub(T.multiplyScalar(T.dot(N))).normalize(),E.crossVectors(x,N);let U=E.dot(l[F])<0?-1:1;o.setXYZW(F,b.x,b.y,b.z,U)}for(let F=0,N=n.count;F<N;++F)c[F]&&w(F);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new Vn(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,m=n.count;d<m;d++)n.setXYZ(d,0,0,0);let s=new V,r=new V,o=new V,a=new V,l=new V,c=new V,h=new V,u=new V;if(e)for(let d=0,m=e.count;d<m;d+=3){let g=e.getX(d+0),y=e.getX(d+1),p=e.getX(d+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,y),o.fromBufferAttribute(t,p),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,y),c.fromBufferAttribute(n,p),a.add(h),l.add(h),c.add(h),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(y,l.x,l.y,l.z),n.setXYZ(p,c.x,c.y,c.z)}else for(let d=0,m=t.count;d<m;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)Rn.fromBufferAttribute(e,t),Rn.normalize(),e.setXYZ(t,Rn.x,Rn.y,Rn.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),m=0,g=0;for(let y=0,p=l.length;y<p;y++){a.isInterleavedBufferAttribute?m=l[y]*a.data.stride+a.offset:m=l[y]*h;for(let f=0;f<h;f++)d[g++]=c[m++]}return new Vn(d,h,u)}if(this.index===null)return Ze("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],m=e(d,n);l.push(m)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let m=c[u];h.push(m.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,m=u.length;d<m;d++)h.push(u[d].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Ud=new V,xM=new V,_M=new nt,mi=class{constructor(e=new V(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Ud.subVectors(n,t).cross(xM.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(Ud),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||_M.getNormalMatrix(e),s=this.coplanarPoint(Ud).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},bM=0,As=class extends as{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:bM++}),this.uuid=Xa(),this.name="",this.type="Material",this.blending=Oo,this.side=hr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Kd,this.blendDst=jd,this.blendEquation=Ir,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new bt(0,0,0),this.blendAlpha=0,this.depthFunc=Eo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=iy,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=cc,this.stencilZFail=cc,this.stencilZPass=cc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){Ze(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ze(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new bt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new mi().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new _t().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new _t().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Ss=new V,Fd=new V,Gl=new V,Hl=new V,sr=class{constructor(e=new V,t=new V(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Ss)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Ss.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Ss.copy(this.origin).addScaledVector(this.direction,t),Ss.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Fd.copy(e).add(t).multiplyScalar(.5),Gl.copy(t).sub(e).normalize(),Hl.copy(this.origin).sub(Fd);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Gl),a=Hl.dot(this.direction),l=-Hl.dot(Gl),c=Hl.lengthSq(),h=Math.abs(1-o*o),u,d,m,g;if(h>0)if(u=o*l-a,d=o*a-l,g=r*h,u>=0)if(d>=-g)if(d<=g){let y=1/h;u*=y,d*=y,m=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),m=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),m=-u*u+d*(d+2*l)+c;else d<=-g?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),m=-u*u+d*(d+2*l)+c):d<=g?(u=0,d=Math.min(Math.max(-r,-l),r),m=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),m=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),m=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Fd).addScaledVector(Gl,d),m}intersectSphere(e,t){if(e.radius<0)return null;Ss.subVectors(e.center,this.origin);let n=Ss.dot(this.direction),s=Ss.dot(Ss)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(n=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),h>=0?(r=(e.min.y-d.y)*h,o=(e.max.y-d.y)*h):(r=(e.max.y-d.y)*h,o=(e.min.y-d.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(e.min.z-d.z)*u,l=(e.max.z-d.z)*u):(a=(e.max.z-d.z)*u,l=(e.min.z-d.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,Ss)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=e.x-o.x,d=e.y-o.y,m=e.z-o.z,g=t.x-o.x,y=t.y-o.y,p=t.z-o.z,f=n.x-o.x,v=n.y-o.y,M=n.z-o.z,b=Math.abs(l),E=Math.abs(c),T=Math.abs(h),x,w,F,N,R,U,k,I,H,Y,W,le;if(b>=E&&b>=T?(F=l,U=u,H=g,le=f,l>=0?(x=c,w=h,N=d,R=m,k=y,I=p,Y=v,W=M):(x=h,w=c,N=m,R=d,k=p,I=y,Y=M,W=v)):E>=T?(F=c,U=d,H=y,le=v,c>=0?(x=h,w=l,N=m,R=u,k=p,I=g,Y=M,W=f):(x=l,w=h,N=u,R=m,k=g,I=p,Y=f,W=M)):(F=h,U=m,H=p,le=M,h>=0?(x=l,w=c,N=u,R=d,k=g,I=y,Y=f,W=v):(x=c,w=l,N=d,R=u,k=y,I=g,Y=v,W=f)),F===0)return null;let Z=x/F,q=w/F,te=1/F,ce=N-Z*U,he=R-q*U,Q=k-Z*H,me=I-q*H,ge=Y-Z*le,Ae=W-q*le,Me=ge*me-Ae*Q,Xe=ce*Ae-he*ge,rt=Q*he-me*ce;if(s){if(Me<0||Xe<0||rt<0)return null}else if((Me<0||Xe<0||rt<0)&&(Me>0||Xe>0||rt>0))return null;let He=Me+Xe+rt;if(He===0)return null;let ut=te*(Me*U+Xe*H+rt*le);return(He>0?ut<0:ut>0)?null:this.at(ut/He,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},wc=class extends As{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new bt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new tr,this.combine=Qd,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},g0=new zt,Tr=new sr,Wl=new ir,y0=new V,Xl=new V,ql=new V,$l=new V,Od=new V,Yl=new V,v0=new V,Jl=new V,Kt=class extends ii{constructor(e=new In,t=new wc){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Yl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(Od.fromBufferAttribute(u,e),o?Yl.addScaledVector(Od,h):Yl.addScaledVector(Od.sub(t),h))}t.add(Yl)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Wl.copy(n.boundingSphere),Wl.applyMatrix4(r),Tr.copy(e.ray).recast(e.near),!(Wl.containsPoint(Tr.origin)===!1&&(Tr.intersectSphere(Wl,y0)===null||Tr.origin.distanceToSquared(y0)>(e.far-e.near)**2))&&(g0.copy(r).invert(),Tr.copy(e.ray).applyMatrix4(g0),!(n.boundingBox!==null&&Tr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Tr)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,m=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,y=d.length;g<y;g++){let p=d[g],f=o[p.materialIndex],v=Math.max(p.start,m.start),M=Math.min(a.count,Math.min(p.start+p.count,m.start+m.count));for(let b=v,E=M;b<E;b+=3){let T=a.getX(b),x=a.getX(b+1),w=a.getX(b+2);s=Zl(this,f,e,n,c,h,u,T,x,w),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,m.start),y=Math.min(a.count,m.start+m.count);for(let p=g,f=y;p<f;p+=3){let v=a.getX(p),M=a.getX(p+1),b=a.getX(p+2);s=Zl(this,o,e,n,c,h,u,v,M,b),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,y=d.length;g<y;g++){let p=d[g],f=o[p.materialIndex],v=Math.max(p.start,m.start),M=Math.min(l.count,Math.min(p.start+p.count,m.start+m.count));for(let b=v,E=M;b<E;b+=3){let T=b,x=b+1,w=b+2;s=Zl(this,f,e,n,c,h,u,T,x,w),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,m.start),y=Math.min(l.count,m.start+m.count);for(let p=g,f=y;p<f;p+=3){let v=p,M=p+1,b=p+2;s=Zl(this,o,e,n,c,h,u,v,M,b),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}}};function MM(i,e,t,n,s,r,o,a){let l;if(e.side===ti?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===hr,a),l===null)return null;Jl.copy(a),Jl.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Jl);return c<t.near||c>t.far?null:{distance:c,point:Jl.clone(),object:i}}function Zl(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,Xl),i.getVertexPosition(l,ql),i.getVertexPosition(c,$l);let h=MM(i,e,t,n,Xl,ql,$l,v0);if(h){let u=new V;ws.getBarycoord(v0,Xl,ql,$l,u),s&&(h.uv=ws.getInterpolatedAttribute(s,a,l,c,u,new _t)),r&&(h.uv1=ws.getInterpolatedAttribute(r,a,l,c,u,new _t)),o&&(h.normal=ws.getInterpolatedAttribute(o,a,l,c,u,new V),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new V,materialIndex:0};ws.getNormal(Xl,ql,$l,d.normal),h.face=d,h.barycoord=u}return h}var Ec=class extends ni{constructor(e=null,t=1,n=1,s,r,o,a,l,c=Pn,h=Pn,u,d){super(null,o,a,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Ar=new ir,SM=new _t(.5,.5),Kl=new V,Rr=class{constructor(e=new mi,t=new mi,n=new mi,s=new mi,r=new mi,o=new mi){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Ti,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],m=r[7],g=r[8],y=r[9],p=r[10],f=r[11],v=r[12],M=r[13],b=r[14],E=r[15];if(s[0].setComponents(c-o,m-h,f-g,E-v).normalize(),s[1].setComponents(c+o,m+h,f+g,E+v).normalize(),s[2].setComponents(c+a,m+u,f+y,E+M).normalize(),s[3].setComponents(c-a,m-u,f-y,E-M).normalize(),n)s[4].setComponents(l,d,p,b).normalize(),s[5].setComponents(c-l,m-d,f-p,E-b).normalize();else if(s[4].setComponents(c-l,m-d,f-p,E-b).normalize(),t===Ti)s[5].setComponents(c+l,m+d,f+p,E+b).normalize();else if(t===wa)s[5].setComponents(l,d,p,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Ar.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Ar.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Ar)}intersectsSprite(e){Ar.center.set(0,0,0);let t=SM.distanceTo(e.center);return Ar.radius=.7071067811865476+t,Ar.applyMatrix4(e.matrixWorld),this.intersectsSphere(Ar)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Kl.x=s.normal.x>0?e.max.x:e.min.x,Kl.y=s.normal.y>0?e.max.y:e.min.y,Kl.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Kl)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},x0=new zt,Tc=class i{constructor(){this.coordinateSystem=Ti,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];x0.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Rr),n[s].setFromProjectionMatrix(x0,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Rr),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var Po=class extends As{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new bt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Ac=new V,Cc=new V,_0=new zt,xa=new sr,jl=new ir,kd=new V,b0=new V,Rc=class extends ii{constructor(e=new In,t=new Po){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)Ac.fromBufferAttribute(t,s-1),Cc.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=Ac.distanceTo(Cc);e.setAttribute("lineDistance",new Zt(n,1))}else Ze("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),jl.copy(n.boundingSphere),jl.applyMatrix4(s),jl.radius+=r,e.ray.intersectsSphere(jl)===!1)return;_0.copy(s).invert(),xa.copy(e.ray).applyMatrix4(_0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let m=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let y=m,p=g-1;y<p;y+=c){let f=h.getX(y),v=h.getX(y+1),M=Ql(this,e,xa,l,f,v,y);M&&t.push(M)}if(this.isLineLoop){let y=h.getX(g-1),p=h.getX(m),f=Ql(this,e,xa,l,y,p,g-1);f&&t.push(f)}}else{let m=Math.max(0,o.start),g=Math.min(d.count,o.start+o.count);for(let y=m,p=g-1;y<p;y+=c){let f=Ql(this,e,xa,l,y,y+1,y);f&&t.push(f)}if(this.isLineLoop){let y=Ql(this,e,xa,l,g-1,m,g-1);y&&t.push(y)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Ql(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(Ac.fromBufferAttribute(a,s),Cc.fromBufferAttribute(a,r),t.distanceSqToSegment(Ac,Cc,kd,b0)>n)return;kd.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(kd);if(!(c<e.near||c>e.far))return{distance:c,point:b0.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var M0=new V,S0=new V,rr=class extends Rc{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)M0.fromBufferAttribute(t,s),S0.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+M0.distanceTo(S0);e.setAttribute("lineDistance",new Zt(n,1))}else Ze("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Pc=class extends As{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new bt(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},w0=new zt,Wd=new sr,ec=new ir,tc=new V,Io=class extends ii{constructor(e=new In,t=new Pc){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),ec.copy(n.boundingSphere),ec.applyMatrix4(s),ec.radius+=r,e.ray.intersectsSphere(ec)===!1)return;w0.copy(s).invert(),Wd.copy(e.ray).applyMatrix4(w0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,u=n.attributes.position;if(c!==null){let d=Math.max(0,o.start),m=Math.min(c.count,o.start+o.count);for(let g=d,y=m;g<y;g++){let p=c.getX(g);tc.fromBufferAttribute(u,p),E0(tc,p,l,s,e,t,this)}}else{let d=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let g=d,y=m;g<y;g++)tc.fromBufferAttribute(u,g),E0(tc,g,l,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function E0(i,e,t,n,s,r,o){let a=Wd.distanceSqToPoint(i);if(a<t){let l=new V;Wd.closestPointToPoint(i,l),l.applyMatrix4(n);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var Pa=class extends ni{constructor(e=[],t=Lr,n,s,r,o,a,l,c,h){super(e,t,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Cs=class extends ni{constructor(e,t,n=zi,s,r,o,a=Pn,l=Pn,c,h=Ts,u=1){if(h!==Ts&&h!==Is)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:u};super(d,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Co(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Ia=class extends Cs{constructor(e,t=zi,n=Lr,s,r,o=Pn,a=Pn,l,c=Ts){let h={width:e,height:e,depth:1},u=[h,h,h,h,h,h];super(e,e,t,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},La=class extends ni{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},or=class i extends In{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,m=0;g("z","y","x",-1,-1,n,t,e,o,r,0),g("z","y","x",1,-1,n,t,-e,o,r,1),g("x","z","y",1,1,e,n,t,s,o,2),g("x","z","y",1,-1,e,n,-t,s,o,3),g("x","y","z",1,-1,e,t,n,s,r,4),g("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Zt(c,3)),this.setAttribute("normal",new Zt(h,3)),this.setAttribute("uv",new Zt(u,2));function g(y,p,f,v,M,b,E,T,x,w,F){let N=b/x,R=E/w,U=b/2,k=E/2,I=T/2,H=x+1,Y=w+1,W=0,le=0,Z=new V;for(let q=0;q<Y;q++){let te=q*R-k;for(let ce=0;ce<H;ce++){let he=ce*N-U;Z[y]=he*v,Z[p]=te*M,Z[f]=I,c.push(Z.x,Z.y,Z.z),Z[y]=0,Z[p]=0,Z[f]=T>0?1:-1,h.push(Z.x,Z.y,Z.z),u.push(ce/x),u.push(1-q/w),W+=1}}for(let q=0;q<w;q++)for(let te=0;te<x;te++){let ce=d+te+H*q,he=d+te+H*(q+1),Q=d+(te+1)+H*(q+1),me=d+(te+1)+H*q;l.push(ce,he,me),l.push(he,Q,me),le+=6}a.addGroup(m,le,F),m+=le,d+=W}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Lo=class i extends In{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],d=[],m=[],g=0,y=[],p=n/2,f=0;v(),o===!1&&(e>0&&M(!0),t>0&&M(!1)),this.setIndex(h),this.setAttribute("position",new Zt(u,3)),this.setAttribute("normal",new Zt(d,3)),this.setAttribute("uv",new Zt(m,2));function v(){let b=new V,E=new V,T=0,x=(t-e)/n;for(let w=0;w<=r;w++){let F=[],N=w/r,R=N*(t-e)+e;for(let U=0;U<=s;U++){let k=U/s,I=k*l+a,H=Math.sin(I),Y=Math.cos(I);E.x=R*H,E.y=-N*n+p,E.z=R*Y,u.push(E.x,E.y,E.z),b.set(H,x,Y).normalize(),d.push(b.x,b.y,b.z),m.push(k,1-N),F.push(g++)}y.push(F)}for(let w=0;w<s;w++)for(let F=0;F<r;F++){let N=y[F][w],R=y[F+1][w],U=y[F+1][w+1],k=y[F][w+1];(e>0||F!==0)&&(h.push(N,R,k),T+=3),(t>0||F!==r-1)&&(h.push(R,U,k),T+=3)}c.addGroup(f,T,0),f+=T}function M(b){let E=g,T=new _t,x=new V,w=0,F=b===!0?e:t,N=b===!0?1:-1;for(let U=1;U<=s;U++)u.push(0,p*N,0),d.push(0,N,0),m.push(.5,.5),g++;let R=g;for(let U=0;U<=s;U++){let I=U/s*l+a,H=Math.cos(I),Y=Math.sin(I);x.x=F*Y,x.y=p*N,x.z=F*H,u.push(x.x,x.y,x.z),d.push(0,N,0),T.x=H*.5+.5,T.y=Y*.5*N+.5,m.push(T.x,T.y),g++}for(let U=0;U<s;U++){let k=E+U,I=R+U;b===!0?h.push(I,I+1,k):h.push(I+1,I,k),w+=3}c.addGroup(f,w,b===!0?1:2),f+=w}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Na=class i extends Lo{constructor(e=1,t=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var nc=new V,ic=new V,Bd=new V,sc=new ws,Da=class extends In{constructor(e=null,t=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:e,thresholdAngle:t},e!==null){let s=Math.pow(10,4),r=Math.cos(hc*t),o=e.getIndex(),a=e.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],h=["a","b","c"],u=new Array(3),d=new Map,m=[];for(let g=0;g<l;g+=3){o?(c[0]=o.getX(g),c[1]=o.getX(g+1),c[2]=o.getX(g+2)):(c[0]=g,c[1]=g+1,c[2]=g+2);let{a:y,b:p,c:f}=sc;if(y.fromBufferAttribute(a,c[0]),p.fromBufferAttribute(a,c[1]),f.fromBufferAttribute(a,c[2]),sc.getNormal(Bd),u[0]=`${Math.round(y.x*s)},${Math.round(y.y*s)},${Math.round(y.z*s)}`,u[1]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,u[2]=`${Math.round(f.x*s)},${Math.round(f.y*s)},${Math.round(f.z*s)}`,!(u[0]===u[1]||u[1]===u[2]||u[2]===u[0]))for(let v=0;v<3;v++){let M=(v+1)%3,b=u[v],E=u[M],T=sc[h[v]],x=sc[h[M]],w=`${b}_${E}`,F=`${E}_${b}`,N=d.get(F);N?(Bd.dot(N.normal)<=r&&(m.push(T.x,T.y,T.z),m.push(x.x,x.y,x.z)),d.set(F,null)):d.has(w)||d.set(w,{index0:c[v],index1:c[M],normal:Bd.clone()})}}for(let g of d.values())if(g){let{index0:y,index1:p}=g;nc.fromBufferAttribute(a,y),ic.fromBufferAttribute(a,p),m.push(nc.x,nc.y,nc.z),m.push(ic.x,ic.y,ic.z)}this.setAttribute("position",new Zt(m,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};var Rs=class i extends In{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=e/a,d=t/l,m=[],g=[],y=[],p=[];for(let f=0;f<h;f++){let v=f*d-o;for(let M=0;M<c;M++){let b=M*u-r;g.push(b,-v,0),y.push(0,0,1),p.push(M/a),p.push(1-f/l)}}for(let f=0;f<l;f++)for(let v=0;v<a;v++){let M=v+c*f,b=v+c*(f+1),E=v+1+c*(f+1),T=v+1+c*f;m.push(M,b,T),m.push(b,E,T)}this.setIndex(m),this.setAttribute("position",new Zt(g,3)),this.setAttribute("normal",new Zt(y,3)),this.setAttribute("uv",new Zt(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var Ps=class i extends In{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new V,d=new V,m=[],g=[],y=[],p=[];for(let f=0;f<=n;f++){let v=[],M=f/n,b=o+M*a,E=e*Math.cos(b),T=Math.sqrt(e*e-E*E),x=0;f===0&&o===0?x=.5/t:f===n&&l===Math.PI&&(x=-.5/t);for(let w=0;w<=t;w++){let F=w/t,N=s+F*r;u.x=-T*Math.cos(N),u.y=E,u.z=T*Math.sin(N),g.push(u.x,u.y,u.z),d.copy(u).normalize(),y.push(d.x,d.y,d.z),p.push(F+x,1-M),v.push(c++)}h.push(v)}for(let f=0;f<n;f++)for(let v=0;v<t;v++){let M=h[f][v+1],b=h[f][v],E=h[f+1][v],T=h[f+1][v+1];(f!==0||o>0)&&m.push(M,b,T),(f!==n-1||l<Math.PI)&&m.push(b,E,T)}this.setIndex(m),this.setAttribute("position",new Zt(g,3)),this.setAttribute("normal",new Zt(y,3)),this.setAttribute("uv",new Zt(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var No=class i extends In{constructor(e=1,t=.4,n=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:n,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},n=Math.floor(n),s=Math.floor(s);let l=[],c=[],h=[],u=[],d=new V,m=new V,g=new V;for(let y=0;y<=n;y++){let p=o+y/n*a;for(let f=0;f<=s;f++){let v=f/s*r;m.x=(e+t*Math.cos(p))*Math.cos(v),m.y=(e+t*Math.cos(p))*Math.sin(v),m.z=t*Math.sin(p),c.push(m.x,m.y,m.z),d.x=e*Math.cos(v),d.y=e*Math.sin(v),g.subVectors(m,d).normalize(),h.push(g.x,g.y,g.z),u.push(f/s),u.push(y/n)}}for(let y=1;y<=n;y++)for(let p=1;p<=s;p++){let f=(s+1)*y+p-1,v=(s+1)*(y-1)+p-1,M=(s+1)*(y-1)+p,b=(s+1)*y+p;l.push(f,v,b),l.push(v,M,b)}this.setIndex(l),this.setAttribute("position",new Zt(c,3)),this.setAttribute("normal",new Zt(h,3)),this.setAttribute("uv",new Zt(u,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc,e.thetaStart,e.thetaLength)}};function Dr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(T0(s))s.isRenderTargetTexture?(Ze("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(T0(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function Hn(i){let e={};for(let t=0;t<i.length;t++){let n=Dr(i[t]);for(let s in n)e[s]=n[s]}return e}function T0(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function wM(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Sf(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:vt.workingColorSpace}var gy={clone:Dr,merge:Hn},EM=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,TM=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Un=class extends As{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=EM,this.fragmentShader=TM,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Dr(e.uniforms),this.uniformsGroups=wM(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new bt().setHex(s.value);break;case"v2":this.uniforms[n].value=new _t().fromArray(s.value);break;case"v3":this.uniforms[n].value=new V().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Qt().fromArray(s.value);break;case"m3":this.uniforms[n].value=new nt().fromArray(s.value);break;case"m4":this.uniforms[n].value=new zt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Ic=class extends Un{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Lc=class extends As{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=ty,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Nc=class extends As{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function bo(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function rc(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var ar=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Dc=class extends ar{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Vd,endingEnd:Vd}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Gd:r=e,a=2*t-n;break;case Hd:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Gd:o=e,l=2*n-t;break;case Hd:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,m=this._weightNext,g=(n-t)/(s-t),y=g*g,p=y*g,f=-d*p+2*d*y-d*g,v=(1+d)*p+(-1.5-2*d)*y+(-.5+d)*g+1,M=(-1-m)*p+(1.5+m)*y+.5*g,b=m*p-m*y;for(let E=0;E!==a;++E)r[E]=f*o[h+E]+v*o[c+E]+M*o[l+E]+b*o[u+E];return r}},Uc=class extends ar{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(n-t)/(s-t),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},Fc=class extends ar{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Oc=class extends ar{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let g=(n-t)/(s-t),y=1-g;for(let p=0;p!==a;++p)r[p]=o[c+p]*y+o[l+p]*g;return r}let d=a*2,m=e-1;for(let g=0;g!==a;++g){let y=o[c+g],p=o[l+g],f=m*d+g*2,v=u[f],M=u[f+1],b=e*d+g*2,E=h[b],T=h[b+1],x=CM(n,t,v,E,s);r[g]=yy(x,y,M,T,p)}return r}};function yy(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function AM(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function CM(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=yy(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let l=AM(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var gi=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=bo(t,this.TimeBufferType),this.values=bo(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:bo(e.times,Array),values:bo(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),rc(e.settings)&&(n.settings={inTangents:bo(e.settings.inTangents,Array),outTangents:bo(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Fc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Uc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Dc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Oc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case ba:t=this.InterpolantFactoryMethodDiscrete;break;case xc:t=this.InterpolantFactoryMethodLinear;break;case lc:t=this.InterpolantFactoryMethodSmooth;break;case zd:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Ze("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ba;case this.InterpolantFactoryMethodLinear:return xc;case this.InterpolantFactoryMethodSmooth:return lc;case this.InterpolantFactoryMethodBezier:return zd}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;rc(this.settings)&&(A0(this.settings.inTangents,e),A0(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;rc(this.settings)&&(C0(this.settings.inTangents,e),C0(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(tt("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(tt("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){tt("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){tt("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&nM(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){tt("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===lc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(s)l=!0;else{let u=a*n,d=u-n,m=u+n;for(let g=0;g!==n;++g){let y=t[u+g];if(y!==t[d+g]||y!==t[m+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let u=a*n,d=o*n;for(let m=0;m!==n;++m)t[d+m]=t[u+m]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,rc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function A0(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function C0(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}gi.prototype.ValueTypeName="";gi.prototype.TimeBufferType=Float32Array;gi.prototype.ValueBufferType=Float32Array;gi.prototype.DefaultInterpolation=xc;var lr=class extends gi{constructor(e,t,n){super(e,t,n)}};lr.prototype.ValueTypeName="bool";lr.prototype.ValueBufferType=Array;lr.prototype.DefaultInterpolation=ba;lr.prototype.InterpolantFactoryMethodLinear=void 0;lr.prototype.InterpolantFactoryMethodSmooth=void 0;var kc=class extends gi{constructor(e,t,n,s){super(e,t,n,s)}};kc.prototype.ValueTypeName="color";var Bc=class extends gi{constructor(e,t,n,s){super(e,t,n,s)}};Bc.prototype.ValueTypeName="number";var zc=class extends ar{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let h=c+a;c!==h;c+=4)Gn.slerpFlat(r,0,o,c-a,o,c,l);return r}},Ua=class extends gi{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new zc(this.times,this.values,this.getValueSize(),e)}};Ua.prototype.ValueTypeName="quaternion";Ua.prototype.InterpolantFactoryMethodSmooth=void 0;var cr=class extends gi{constructor(e,t,n){super(e,t,n)}};cr.prototype.ValueTypeName="string";cr.prototype.ValueBufferType=Array;cr.prototype.DefaultInterpolation=ba;cr.prototype.InterpolantFactoryMethodLinear=void 0;cr.prototype.InterpolantFactoryMethodSmooth=void 0;var Vc=class extends gi{constructor(e,t,n,s){super(e,t,n,s)}};Vc.prototype.ValueTypeName="vector";var Gc=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let m=c[u],g=c[u+1];if(m.global&&(m.lastIndex=0),m.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},vy=new Gc,Hc=class{constructor(e){this.manager=e!==void 0?e:vy,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Hc.DEFAULT_MATERIAL_NAME="__DEFAULT";var oc=new V,ac=new Gn,rs=new V,Fa=class extends ii{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new zt,this.projectionMatrix=new zt,this.projectionMatrixInverse=new zt,this.coordinateSystem=Ti,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(oc,ac,rs),rs.x===1&&rs.y===1&&rs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(oc,ac,rs.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(oc,ac,rs),rs.x===1&&rs.y===1&&rs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(oc,ac,rs.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},er=new V,R0=new _t,P0=new _t,jn=class extends Fa{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=_c*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(hc*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return _c*2*Math.atan(Math.tan(hc*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){er.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(er.x,er.y).multiplyScalar(-e/er.z),er.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(er.x,er.y).multiplyScalar(-e/er.z)}getViewSize(e,t){return this.getViewBounds(e,R0,P0),t.subVectors(P0,R0)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(hc*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Do=class extends Fa{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var Mo=-90,So=1,Uo=class extends ii{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new jn(Mo,So,e,t);s.layers=this.layers,this.add(s);let r=new jn(Mo,So,e,t);r.layers=this.layers,this.add(r);let o=new jn(Mo,So,e,t);o.layers=this.layers,this.add(o);let a=new jn(Mo,So,e,t);a.layers=this.layers,this.add(a);let l=new jn(Mo,So,e,t);l.layers=this.layers,this.add(l);let c=new jn(Mo,So,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Ti)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===wa)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=e.getRenderTarget(),d=e.getActiveCubeFace(),m=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let y=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let p=!1;e.isWebGLRenderer===!0?p=e.state.buffers.depth.getReversed():p=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=y,e.setRenderTarget(n,5,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(u,d,m),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},Wc=class extends jn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var wf="\\[\\]\\.:\\/",RM=new RegExp("["+wf+"]","g"),Ef="[^"+wf+"]",PM="[^"+wf.replace("\\.","")+"]",IM=/((?:WC+[\/:])*)/.source.replace("WC",Ef),LM=/(WCOD+)?/.source.replace("WCOD",PM),NM=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Ef),DM=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Ef),UM=new RegExp("^"+IM+LM+NM+DM+"$"),FM=["material","materials","bones","map"],Xd=class{constructor(e,t,n){let s=n||qt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},qt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(RM,"")}static parseTrackName(e){let t=UM.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);FM.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ze("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){tt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){tt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){tt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){tt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){tt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){tt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){tt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;tt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){tt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){tt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};qt.Composite=Xd;qt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};qt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};qt.prototype.GetterByBindingType=[qt.prototype._getValue_direct,qt.prototype._getValue_array,qt.prototype._getValue_arrayElement,qt.prototype._getValue_toArray];qt.prototype.SetterByBindingTypeAndVersioning=[[qt.prototype._setValue_direct,qt.prototype._setValue_direct_setNeedsUpdate,qt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_array,qt.prototype._setValue_array_setNeedsUpdate,qt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_arrayElement,qt.prototype._setValue_arrayElement_setNeedsUpdate,qt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[qt.prototype._setValue_fromArray,qt.prototype._setValue_fromArray_setNeedsUpdate,qt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var bR=new Float32Array(1);var qd=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};function Tf(i,e,t,n){let s=OM(n);switch(t){case ff:return i*e;case mf:return i*e/s.components*s.byteLength;case Kc:return i*e/s.components*s.byteLength;case ur:return i*e*2/s.components*s.byteLength;case jc:return i*e*2/s.components*s.byteLength;case pf:return i*e*3/s.components*s.byteLength;case Hi:return i*e*4/s.components*s.byteLength;case Qc:return i*e*4/s.components*s.byteLength;case Ba:case za:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Va:case Ga:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case th:case ih:return Math.max(i,16)*Math.max(e,8)/4;case eh:case nh:return Math.max(i,8)*Math.max(e,8)/2;case sh:case rh:case ah:case lh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case oh:case Ha:case ch:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case hh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case uh:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case dh:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case fh:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case ph:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case mh:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case gh:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case yh:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case vh:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case xh:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case _h:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case bh:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case Mh:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case Sh:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case wh:case Eh:case Th:return Math.ceil(i/4)*Math.ceil(e/4)*16;case Ah:case Ch:return Math.ceil(i/4)*Math.ceil(e/4)*8;case Wa:case Rh:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function OM(i){switch(i){case yi:case cf:return{byteLength:1,components:1};case Bo:case hf:case Gi:return{byteLength:2,components:1};case Jc:case Zc:return{byteLength:2,components:4};case zi:case Yc:case Vi:return{byteLength:4,components:1};case uf:case df:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ze("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function zy(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function BM(i){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),a.onUploadCallback();let m;if(c instanceof Float32Array)m=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)m=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?m=i.HALF_FLOAT:m=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)m=i.SHORT;else if(c instanceof Uint32Array)m=i.UNSIGNED_INT;else if(c instanceof Int32Array)m=i.INT;else if(c instanceof Int8Array)m=i.BYTE;else if(c instanceof Uint8Array)m=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)m=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:m,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((m,g)=>m.start-g.start);let d=0;for(let m=1;m<u.length;m++){let g=u[d],y=u[m];y.start<=g.start+g.count+1?g.count=Math.max(g.count,y.start+y.count-g.start):(++d,u[d]=y)}u.length=d+1;for(let m=0,g=u.length;m<g;m++){let y=u[m];i.bufferSubData(c,y.start*h.BYTES_PER_ELEMENT,h,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var zM=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,VM=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,GM=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,HM=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,WM=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,XM=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,qM=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,$M=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,YM=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,JM=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,ZM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,KM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,jM=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,QM=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,eS=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,tS=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,nS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,iS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,sS=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,rS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,oS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,aS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,lS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,cS=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,hS=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,uS=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,dS=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,fS=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,pS=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,mS="gl_FragColor = linearToOutputTexel( gl_FragColor );",gS=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,yS=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,vS=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,xS=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,_S=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,bS=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,MS=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,SS=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,wS=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,ES=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,TS=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,AS=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,CS=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,RS=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,PS=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,IS=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,LS=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,NS=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,DS=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,US=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,FS=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,OS=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,kS=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,BS=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,zS=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,VS=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,GS=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,HS=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,WS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,XS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,qS=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,$S=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,YS=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,JS=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,ZS=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,KS=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,jS=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,QS=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,ew=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,tw=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,nw=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,iw=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,sw=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,rw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,ow=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,aw=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,lw=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,cw=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,hw=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,uw=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,dw=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,fw=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,pw=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,mw=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,gw=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,yw=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,vw=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,xw=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,_w=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,bw=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,Mw=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,Sw=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,ww=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,Ew=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Tw=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,Aw=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Cw=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,Rw=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Pw=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Iw=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Lw=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,Nw=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,Dw=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,Uw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Fw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Ow=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,kw=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Bw=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,zw=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Vw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Gw=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Hw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Ww=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Xw=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,qw=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,$w=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,Yw=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,Jw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Zw=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Kw=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,jw=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Qw=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,e1=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,t1=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,n1=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,i1=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,s1=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,r1=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,o1=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,a1=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,l1=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,c1=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,h1=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,u1=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,d1=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,f1=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,p1=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,m1=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,g1=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,y1=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,v1=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ht={alphahash_fragment:zM,alphahash_pars_fragment:VM,alphamap_fragment:GM,alphamap_pars_fragment:HM,alphatest_fragment:WM,alphatest_pars_fragment:XM,aomap_fragment:qM,aomap_pars_fragment:$M,batching_pars_vertex:YM,batching_vertex:JM,begin_vertex:ZM,beginnormal_vertex:KM,bsdfs:jM,iridescence_fragment:QM,bumpmap_pars_fragment:eS,clipping_planes_fragment:tS,clipping_planes_pars_fragment:nS,clipping_planes_pars_vertex:iS,clipping_planes_vertex:sS,color_fragment:rS,color_pars_fragment:oS,color_pars_vertex:aS,color_vertex:lS,common:cS,defaultnormal_vertex:hS,displacementmap_pars_vertex:uS,displacementmap_vertex:dS,emissivemap_fragment:fS,emissivemap_pars_fragment:pS,colorspace_fragment:mS,colorspace_pars_fragment:gS,envmap_fragment:yS,envmap_common_pars_fragment:vS,envmap_pars_fragment:xS,envmap_pars_vertex:_S,envmap_physical_pars_fragment:IS,envmap_vertex:bS,fog_vertex:MS,fog_pars_vertex:SS,fog_fragment:wS,fog_pars_fragment:ES,gradientmap_pars_fragment:TS,lightmap_pars_fragment:AS,lights_lambert_fragment:CS,lights_lambert_pars_fragment:RS,lights_pars_begin:PS,lights_toon_fragment:LS,lights_toon_pars_fragment:NS,lights_phong_fragment:DS,lights_phong_pars_fragment:US,lights_physical_fragment:FS,lights_physical_pars_fragment:OS,lights_fragment_begin:kS,lights_fragment_maps:BS,lights_fragment_end:zS,lightprobes_pars_fragment:VS,logdepthbuf_fragment:GS,logdepthbuf_pars_fragment:HS,logdepthbuf_pars_vertex:WS,logdepthbuf_vertex:XS,map_fragment:qS,map_pars_fragment:$S,map_particle_fragment:YS,map_particle_pars_fragment:JS,metalnessmap_fragment:ZS,metalnessmap_pars_fragment:KS,morphinstance_vertex:jS,morphcolor_vertex:QS,morphnormal_vertex:ew,morphtarget_pars_vertex:tw,morphtarget_vertex:nw,normal_fragment_begin:iw,normal_fragment_maps:sw,normal_pars_fragment:rw,normal_pars_vertex:ow,normal_vertex:aw,normalmap_pars_fragment:lw,clearcoat_normal_fragment_begin:cw,clearcoat_normal_fragment_maps:hw,clearcoat_pars_fragment:uw,iridescence_pars_fragment:dw,opaque_fragment:fw,packing:pw,premultiplied_alpha_fragment:mw,project_vertex:gw,dithering_fragment:yw,dithering_pars_fragment:vw,roughnessmap_fragment:xw,roughnessmap_pars_fragment:_w,shadowmap_pars_fragment:bw,shadowmap_pars_vertex:Mw,shadowmap_vertex:Sw,shadowmask_pars_fragment:ww,skinbase_vertex:Ew,skinning_pars_vertex:Tw,skinning_vertex:Aw,skinnormal_vertex:Cw,specularmap_fragment:Rw,specularmap_pars_fragment:Pw,tonemapping_fragment:Iw,tonemapping_pars_fragment:Lw,transmission_fragment:Nw,transmission_pars_fragment:Dw,uv_pars_fragment:Uw,uv_pars_vertex:Fw,uv_vertex:Ow,worldpos_vertex:kw,background_vert:Bw,background_frag:zw,backgroundCube_vert:Vw,backgroundCube_frag:Gw,cube_vert:Hw,cube_frag:Ww,depth_vert:Xw,depth_frag:qw,distance_vert:$w,distance_frag:Yw,equirect_vert:Jw,equirect_frag:Zw,linedashed_vert:Kw,linedashed_frag:jw,meshbasic_vert:Qw,meshbasic_frag:e1,meshlambert_vert:t1,meshlambert_frag:n1,meshmatcap_vert:i1,meshmatcap_frag:s1,meshnormal_vert:r1,meshnormal_frag:o1,meshphong_vert:a1,meshphong_frag:l1,meshphysical_vert:c1,meshphysical_frag:h1,meshtoon_vert:u1,meshtoon_frag:d1,points_vert:f1,points_frag:p1,shadow_vert:m1,shadow_frag:g1,sprite_vert:y1,sprite_frag:v1},Ne={common:{diffuse:{value:new bt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new nt},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new nt}},envmap:{envMap:{value:null},envMapRotation:{value:new nt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new nt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new nt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new nt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new nt},normalScale:{value:new _t(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new nt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new nt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new nt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new nt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new bt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new bt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0},uvTransform:{value:new nt}},sprite:{diffuse:{value:new bt(16777215)},opacity:{value:1},center:{value:new _t(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new nt},alphaMap:{value:null},alphaMapTransform:{value:new nt},alphaTest:{value:0}}},us={basic:{uniforms:Hn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.fog]),vertexShader:ht.meshbasic_vert,fragmentShader:ht.meshbasic_frag},lambert:{uniforms:Hn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new bt(0)},envMapIntensity:{value:1}}]),vertexShader:ht.meshlambert_vert,fragmentShader:ht.meshlambert_frag},phong:{uniforms:Hn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new bt(0)},specular:{value:new bt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ht.meshphong_vert,fragmentShader:ht.meshphong_frag},standard:{uniforms:Hn([Ne.common,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.roughnessmap,Ne.metalnessmap,Ne.fog,Ne.lights,{emissive:{value:new bt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag},toon:{uniforms:Hn([Ne.common,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.gradientmap,Ne.fog,Ne.lights,{emissive:{value:new bt(0)}}]),vertexShader:ht.meshtoon_vert,fragmentShader:ht.meshtoon_frag},matcap:{uniforms:Hn([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,{matcap:{value:null}}]),vertexShader:ht.meshmatcap_vert,fragmentShader:ht.meshmatcap_frag},points:{uniforms:Hn([Ne.points,Ne.fog]),vertexShader:ht.points_vert,fragmentShader:ht.points_frag},dashed:{uniforms:Hn([Ne.common,Ne.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ht.linedashed_vert,fragmentShader:ht.linedashed_frag},depth:{uniforms:Hn([Ne.common,Ne.displacementmap]),vertexShader:ht.depth_vert,fragmentShader:ht.depth_frag},normal:{uniforms:Hn([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,{opacity:{value:1}}]),vertexShader:ht.meshnormal_vert,fragmentShader:ht.meshnormal_frag},sprite:{uniforms:Hn([Ne.sprite,Ne.fog]),vertexShader:ht.sprite_vert,fragmentShader:ht.sprite_frag},background:{uniforms:{uvTransform:{value:new nt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ht.background_vert,fragmentShader:ht.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new nt}},vertexShader:ht.backgroundCube_vert,fragmentShader:ht.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ht.cube_vert,fragmentShader:ht.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ht.equirect_vert,fragmentShader:ht.equirect_frag},distance:{uniforms:Hn([Ne.common,Ne.displacementmap,{referencePosition:{value:new V},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ht.distance_vert,fragmentShader:ht.distance_frag},shadow:{uniforms:Hn([Ne.lights,Ne.fog,{color:{value:new bt(0)},opacity:{value:1}}]),vertexShader:ht.shadow_vert,fragmentShader:ht.shadow_frag}};us.physical={uniforms:Hn([us.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new nt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new nt},clearcoatNormalScale:{value:new _t(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new nt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new nt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new nt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new nt},sheen:{value:0},sheenColor:{value:new bt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new nt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new nt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new nt},transmissionSamplerSize:{value:new _t},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new nt},attenuationDistance:{value:0},attenuationColor:{value:new bt(0)},specularColor:{value:new bt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new nt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new nt},anisotropyVector:{value:new _t},anisotropyMap:{value:null},anisotropyMapTransform:{value:new nt}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag};var Ih={r:0,b:0,g:0},x1=new zt,Vy=new nt;Vy.set(-1,0,0,0,1,0,0,0,1);function _1(i,e,t,n,s,r){let o=new bt(0),a=s===!0?0:1,l,c,h=null,u=0,d=null;function m(v){let M=v.isScene===!0?v.background:null;if(M&&M.isTexture){let b=v.backgroundBlurriness>0;M=e.get(M,b)}return M}function g(v){let M=!1,b=m(v);b===null?p(o,a):b&&b.isColor&&(p(b,1),M=!0);let E=i.xr.getEnvironmentBlendMode();E==="additive"?t.buffers.color.setClear(0,0,0,1,r):E==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||M)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function y(v,M){let b=m(M);b&&b.isCubeTexture?(c===void 0&&(c=new Kt(new or(1,1,1),new Un({name:"BackgroundCubeMaterial",uniforms:Dr(us.backgroundCube.uniforms),vertexShader:us.backgroundCube.vertexShader,fragmentShader:us.backgroundCube.fragmentShader,side:ti,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(E,T,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(x1.makeRotationFromEuler(M.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Vy),c.material.toneMapped=vt.getTransfer(b.colorSpace)!==Pt,(h!==b||u!==b.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=b,u=b.version,d=i.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new Kt(new Rs(2,2),new Un({name:"BackgroundMaterial",uniforms:Dr(us.background.uniforms),vertexShader:us.background.vertexShader,fragmentShader:us.background.fragmentShader,side:hr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.toneMapped=vt.getTransfer(b.colorSpace)!==Pt,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(h!==b||u!==b.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=b,u=b.version,d=i.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function p(v,M){v.getRGB(Ih,Sf(i)),t.buffers.color.setClear(Ih.r,Ih.g,Ih.b,M,r)}function f(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,M=1){o.set(v),a=M,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,p(o,a)},render:g,addToRenderList:y,dispose:f}}function b1(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(R,U,k,I,H){let Y=!1,W=u(R,I,k,U);r!==W&&(r=W,c(r.object)),Y=m(R,I,k,H),Y&&g(R,I,k,H),H!==null&&e.update(H,i.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,b(R,U,k,I),H!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(H).buffer))}function l(){return i.createVertexArray()}function c(R){return i.bindVertexArray(R)}function h(R){return i.deleteVertexArray(R)}function u(R,U,k,I){let H=I.wireframe===!0,Y=n[U.id];Y===void 0&&(Y={},n[U.id]=Y);let W=R.isInstancedMesh===!0?R.id:0,le=Y[W];le===void 0&&(le={},Y[W]=le);let Z=le[k.id];Z===void 0&&(Z={},le[k.id]=Z);let q=Z[H];return q===void 0&&(q=d(l()),Z[H]=q),q}function d(R){let U=[],k=[],I=[];for(let H=0;H<t;H++)U[H]=0,k[H]=0,I[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:U,enabledAttributes:k,attributeDivisors:I,object:R,attributes:{},index:null}}function m(R,U,k,I){let H=r.attributes,Y=U.attributes,W=0,le=k.getAttributes();for(let Z in le)if(le[Z].location>=0){let te=H[Z],ce=Y[Z];if(ce===void 0&&(Z==="instanceMatrix"&&R.instanceMatrix&&(ce=R.instanceMatrix),Z==="instanceColor"&&R.instanceColor&&(ce=R.instanceColor)),te===void 0||te.attribute!==ce||ce&&te.data!==ce.data)return!0;W++}return r.attributesNum!==W||r.index!==I}function g(R,U,k,I){let H={},Y=U.attributes,W=0,le=k.getAttributes();for(let Z in le)if(le[Z].location>=0){let te=Y[Z];te===void 0&&(Z==="instanceMatrix"&&R.instanceMatrix&&(te=R.instanceMatrix),Z==="instanceColor"&&R.instanceColor&&(te=R.instanceColor));let ce={};ce.attribute=te,te&&te.data&&(ce.data=te.data),H[Z]=ce,W++}r.attributes=H,r.attributesNum=W,r.index=I}function y(){let R=r.newAttributes;for(let U=0,k=R.length;U<k;U++)R[U]=0}function p(R){f(R,0)}function f(R,U){let k=r.newAttributes,I=r.enabledAttributes,H=r.attributeDivisors;k[R]=1,I[R]===0&&(i.enableVertexAttribArray(R),I[R]=1),H[R]!==U&&(i.vertexAttribDivisor(R,U),H[R]=U)}function v(){let R=r.newAttributes,U=r.enabledAttributes;for(let k=0,I=U.length;k<I;k++)U[k]!==R[k]&&(i.disableVertexAttribArray(k),U[k]=0)}function M(R,U,k,I,H,Y,W){W===!0?i.vertexAttribIPointer(R,U,k,H,Y):i.vertexAttribPointer(R,U,k,I,H,Y)}function b(R,U,k,I){y();let H=I.attributes,Y=k.getAttributes(),W=U.defaultAttributeValues;for(let le in Y){let Z=Y[le];if(Z.location>=0){let q=H[le];if(q===void 0&&(le==="instanceMatrix"&&R.instanceMatrix&&(q=R.instanceMatrix),le==="instanceColor"&&R.instanceColor&&(q=R.instanceColor)),q!==void 0){let te=q.normalized,ce=q.itemSize,he=e.get(q);if(he===void 0)continue;let Q=he.buffer,me=he.type,ge=he.bytesPerElement,Ae=me===i.INT||me===i.UNSIGNED_INT||q.gpuType===Yc;if(q.isInterleavedBufferAttribute){let Me=q.data,Xe=Me.isInterleavedBuffer===!0?Me.stride:Me.itemSize,rt=q.offset;if(Me.isInstancedInterleavedBuffer||Me.isInstancedBufferAttribute){for(let He=0;He<Z.locationSize;He++)f(Z.location+He,Me.meshPerAttribute);R.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=Me.meshPerAttribute*Me.count)}else for(let He=0;He<Z.locationSize;He++)p(Z.location+He);i.bindBuffer(i.ARRAY_BUFFER,Q);for(let He=0;He<Z.locationSize;He++)M(Z.location+He,ce/Z.locationSize,me,te,Xe*ge,(rt+ce/Z.locationSize*He)*ge,Ae)}else{if(q.isInstancedBufferAttribute){for(let Me=0;Me<Z.locationSize;Me++)f(Z.location+Me,q.meshPerAttribute);R.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=q.meshPerAttribute*q.count)}else for(let Me=0;Me<Z.locationSize;Me++)p(Z.location+Me);i.bindBuffer(i.ARRAY_BUFFER,Q);for(let Me=0;Me<Z.locationSize;Me++)M(Z.location+Me,ce/Z.locationSize,me,te,ce*ge,ce/Z.locationSize*Me*ge,Ae)}}else if(W!==void 0){let te=W[le];if(te!==void 0)switch(te.length){case 2:i.vertexAttrib2fv(Z.location,te);break;case 3:i.vertexAttrib3fv(Z.location,te);break;case 4:i.vertexAttrib4fv(Z.location,te);break;default:i.vertexAttrib1fv(Z.location,te)}}}}v()}function E(){F();for(let R in n){let U=n[R];for(let k in U){let I=U[k];for(let H in I){let Y=I[H];for(let W in Y)h(Y[W].object),delete Y[W];delete I[H]}}delete n[R]}}function T(R){if(n[R.id]===void 0)return;let U=n[R.id];for(let k in U){let I=U[k];for(let H in I){let Y=I[H];for(let W in Y)h(Y[W].object),delete Y[W];delete I[H]}}delete n[R.id]}function x(R){for(let U in n){let k=n[U];for(let I in k){let H=k[I];if(H[R.id]===void 0)continue;let Y=H[R.id];for(let W in Y)h(Y[W].object),delete Y[W];delete H[R.id]}}}function w(R){for(let U in n){let k=n[U],I=R.isInstancedMesh===!0?R.id:0,H=k[I];if(H!==void 0){for(let Y in H){let W=H[Y];for(let le in W)h(W[le].object),delete W[le];delete H[Y]}delete k[I],Object.keys(k).length===0&&delete n[U]}}}function F(){N(),o=!0,r!==s&&(r=s,c(r.object))}function N(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:F,resetDefaultState:N,dispose:E,releaseStatesOfGeometry:T,releaseStatesOfObject:w,releaseStatesOfProgram:x,initAttributes:y,enableAttribute:p,disableUnusedAttributes:v}}function M1(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),t.update(c,n,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let d=0;for(let m=0;m<h;m++)d+=c[m];t.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function S1(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==Hi&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let w=x===Gi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==yi&&x!==Vi&&!w&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(Ze("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&u===!1;t.reversedDepthBuffer===!0&&u===!1&&Ze("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&u===!0&&Ze("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let m=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=i.getParameter(i.MAX_TEXTURE_SIZE),p=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),f=i.getParameter(i.MAX_VERTEX_ATTRIBS),v=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),M=i.getParameter(i.MAX_VARYING_VECTORS),b=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),E=i.getParameter(i.MAX_SAMPLES),T=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:m,maxVertexTextures:g,maxTextureSize:y,maxCubemapSize:p,maxAttributes:f,maxVertexUniforms:v,maxVaryings:M,maxFragmentUniforms:b,maxSamples:E,samples:T}}function w1(i){let e=this,t=null,n=0,s=!1,r=!1,o=new mi,a=new nt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let m=u.length!==0||d||n!==0||s;return s=d,n=u.length,m},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){t=h(u,d,0)},this.setState=function(u,d,m){let g=u.clippingPlanes,y=u.clipIntersection,p=u.clipShadows,f=i.get(u);if(!s||g===null||g.length===0||r&&!p)r?h(null):c();else{let v=r?0:n,M=v*4,b=f.clippingState||null;l.value=b,b=h(g,d,M,m);for(let E=0;E!==M;++E)b[E]=t[E];f.clippingState=b,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(u,d,m,g){let y=u!==null?u.length:0,p=null;if(y!==0){if(p=l.value,g!==!0||p===null){let f=m+y*4,v=d.matrixWorldInverse;a.getNormalMatrix(v),(p===null||p.length<f)&&(p=new Float32Array(f));for(let M=0,b=m;M!==y;++M,b+=4)o.copy(u[M]).applyMatrix4(v,a),o.normal.toArray(p,b),p[b+3]=o.constant}l.value=p,l.needsUpdate=!0}return e.numPlanes=y,e.numIntersection=0,p}}var Ya=class extends ei{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new Pa(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new or(5,5,5),r=new Un({name:"CubemapFromEquirect",uniforms:Dr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:ti,blending:Pr});r.uniforms.tEquirect.value=t;let o=new Kt(s,r),a=t.minFilter;return t.minFilter===Bi&&(t.minFilter=Dn),new Uo(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},xy=256,E1=3,T1=20,Gy=256,Hy=16,A1=3,C1=new V,R1=new bt,Nh=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Uo(1,10,null),this._boxMesh=new Kt(new or(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=C1}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,m=l.autoClearDepth,g=l.autoClearStencil,y=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(e.background=l.getClearColor(R1));let p=new Uo(n,s,h);return p.position.copy(a),p.update(l,e),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=m,l.autoClearStencil=g,e.background=y,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=My(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=by(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(xy,py(e))}_fromTexture(e,t){e.mapping===Lr||e.mapping===ko?this._setSize(e.image.length===0?xy:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=_y(e,!1,!1),n=Math.log2(e)-E1;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=_y(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Lr||e.mapping===ko?(this._cubemapMaterial===null&&(this._cubemapMaterial=My()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=by()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=P1(),this._integrationMaterial=I1());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Hy);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-A1)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Gy*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=L1());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function _y(i,e,t){return new Ya(i,{minFilter:Bi,generateMipmaps:e,type:Gi,colorSpace:Ma,depthBuffer:t})}function Ja(i,e,t){return new Un({name:i,uniforms:e,vertexShader:ht.cube_vert,fragmentShader:t,side:ti,blending:Pr,depthTest:!1,depthWrite:!1})}function P1(){return Ja("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Gy}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function I1(){return Ja("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Hy}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function L1(){return Ja("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${T1}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function by(){return Ja("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function My(){return Ja("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function N1(i){let e=new WeakMap,t=new WeakMap,n=null;function s(d,m=!1){return d==null?null:m?o(d):r(d)}function r(d){if(d&&d.isTexture){let m=d.mapping;if(m===Xc||m===qc)if(e.has(d)){let g=e.get(d).texture;return a(g,d.mapping)}else{let g=d.image;if(g&&g.height>0){let y=new Ya(g.height);return y.fromEquirectangularTexture(i,d),e.set(d,y),d.addEventListener("dispose",c),a(y.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let m=d.mapping,g=m===Xc||m===qc,y=m===Lr||m===ko;if(g||y){let p=t.get(d),f=p!==void 0?p.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==f)return n===null&&(n=new Nh(i)),p=g?n.fromEquirectangular(d,p):n.fromCubemap(d,p),p.texture.pmremVersion=d.pmremVersion,t.set(d,p),p.texture;if(p!==void 0)return p.texture;{let v=d.image;return g&&v&&v.height>0||y&&v&&l(v)?(n===null&&(n=new Nh(i)),p=g?n.fromEquirectangular(d):n.fromCubemap(d),p.texture.pmremVersion=d.pmremVersion,t.set(d,p),d.addEventListener("dispose",h),p.texture):null}}}return d}function a(d,m){return m===Xc?d.mapping=Lr:m===qc&&(d.mapping=ko),d}function l(d){let m=0,g=6;for(let y=0;y<g;y++)d[y]!==void 0&&m++;return m===g}function c(d){let m=d.target;m.removeEventListener("dispose",c);let g=e.get(m);g!==void 0&&(e.delete(m),g.dispose())}function h(d){let m=d.target;m.removeEventListener("dispose",h);let g=t.get(m);g!==void 0&&(t.delete(m),g.dispose())}function u(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function D1(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&_a("WebGLRenderer: "+n+" extension not supported."),s}}}function U1(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let p in g.attributes)e.remove(g.attributes[p]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let y=r.get(g);y&&(e.remove(y),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),t.memory.geometries++),y}function h(g){let y=g.attributes;for(let p in y)e.update(y[p],i.ARRAY_BUFFER)}function u(g){let y=g.index,p=g.attributes.position,f=0;if(p===void 0)return;let v=y!==null?y.array.length:p.array.length/3-1,M=p.count>=65535?Ra:Ca,b=new M(Math.ceil(v/3)*6,1),E=b.array;if(y!==null){let x=y.array;f=y.version;for(let w=0,F=0;w<v;w+=3){let N=x[w+0],R=x[w+1],U=x[w+2];E[F++]=N,E[F++]=R,E[F++]=R,E[F++]=U,E[F++]=U,E[F++]=N}}else{f=p.version;for(let x=0,w=0;x<v;x+=3){let F=x+0,N=x+1,R=x+2;E[w++]=F,E[w++]=N,E[w++]=N,E[w++]=R,E[w++]=R,E[w++]=F}}b.version=f;let T=r.get(g);T&&e.remove(T),r.set(g,b)}function d(g){let y=r.get(g);if(y){let p=g.index;p!==null&&y.version<p.version&&u(g)}else u(g);return r.get(g)}function m(){for(let g in s){let y=s[g].deref();y!==void 0&&l(y)}}return{get:c,update:h,getWireframeAttribute:d,dispose:m}}function F1(i,e,t){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){i.drawElements(n,d,r,u*o),t.update(d,n,1)}function c(u,d,m){m!==0&&(i.drawElementsInstanced(n,d,r,u*o,m),t.update(d,n,m))}function h(u,d,m){if(m===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,m);let y=0;for(let p=0;p<m;p++)y+=d[p];t.update(y,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function O1(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:tt("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function k1(i,e,t){let n=new WeakMap,s=new Qt;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=n.get(a);if(d===void 0||d.count!==u){let F=function(){x.dispose(),n.delete(a),a.removeEventListener("dispose",F)};d!==void 0&&d.texture.dispose();let m=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],f=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],M=0;m===!0&&(M=1),g===!0&&(M=2),y===!0&&(M=3);let b=a.attributes.position.count*M,E=1;b>e.maxTextureSize&&(E=Math.ceil(b/e.maxTextureSize),b=e.maxTextureSize);let T=new Float32Array(b*E*4*u),x=new Ta(T,b,E,u);x.type=Vi,x.needsUpdate=!0;let w=M*4;for(let N=0;N<u;N++){let R=p[N],U=f[N],k=v[N],I=b*E*4*N;for(let H=0;H<R.count;H++){let Y=H*w;m===!0&&(s.fromBufferAttribute(R,H),T[I+Y+0]=s.x,T[I+Y+1]=s.y,T[I+Y+2]=s.z,T[I+Y+3]=0),g===!0&&(s.fromBufferAttribute(U,H),T[I+Y+4]=s.x,T[I+Y+5]=s.y,T[I+Y+6]=s.z,T[I+Y+7]=0),y===!0&&(s.fromBufferAttribute(k,H),T[I+Y+8]=s.x,T[I+Y+9]=s.y,T[I+Y+10]=s.z,T[I+Y+11]=k.itemSize===4?s.w:1)}}d={count:u,texture:x,size:new _t(b,E)},n.set(a,d),a.addEventListener("dispose",F)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let m=0;for(let y=0;y<c.length;y++)m+=c[y];let g=a.morphTargetsRelative?1:1-m;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function B1(i,e,t,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,d=e.get(c,u);if(r.get(d)!==h&&(e.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let m=c.skeleton;r.get(m)!==h&&(m.update(),r.set(m,h))}return d}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var z1={[ef]:"LINEAR_TONE_MAPPING",[tf]:"REINHARD_TONE_MAPPING",[nf]:"CINEON_TONE_MAPPING",[sf]:"ACES_FILMIC_TONE_MAPPING",[of]:"AGX_TONE_MAPPING",[af]:"NEUTRAL_TONE_MAPPING",[rf]:"CUSTOM_TONE_MAPPING"};function V1(i,e,t,n,s,r){let o=new ei(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new In;h.setAttribute("position",new Zt([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Zt([0,2,0,0,2,0],2));let u=new Ic({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new Kt(h,u),m=new Do(-1,1,1,-1,0,1),g=null,y=null,p=!1,f,v=null,M=[],b=!1;this.setSize=function(E,T){o.setSize(E,T),a!==null&&a.setSize(E,T),l!==null&&l.setSize(E,T);for(let x=0;x<M.length;x++){let w=M[x];w.setSize&&w.setSize(E,T)}},this.setEffects=function(E){M=E,b=M.length>0&&M[0].isRenderPass===!0;let T=o.width,x=o.height;M.length>0&&a===null&&(a=new ei(T,x,{type:Gi,depthBuffer:!1,stencilBuffer:!1}),l=new ei(T,x,{type:Gi,depthBuffer:!1,stencilBuffer:!1}));let w=s===!0&&M.some(F=>F.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&c===null&&(c=new Cs(T,x),r===!0&&(c.format=Is,c.type=Nr)),o.dispose(),o.depthTexture=w?c:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let F=0;F<M.length;F++){let N=M[F];N.setSize&&N.setSize(T,x),w&&N.needsDepthTexture===!0&&N.setDepthTexture&&N.setDepthTexture(c)}},this.begin=function(E,T){if(p||E.toneMapping===cs&&M.length===0)return!1;if(v=T,T!==null){let x=T.width,w=T.height;(o.width!==x||o.height!==w)&&this.setSize(x,w)}return b===!1&&E.setRenderTarget(o),f=E.toneMapping,E.toneMapping=cs,!0},this.hasRenderPass=function(){return b},this.end=function(E,T){E.toneMapping=f,p=!0;let x=o,w=a;for(let F=0;F<M.length;F++){let N=M[F];N.enabled!==!1&&(N.render(E,w,x,T),N.needsSwap!==!1&&(x=w,w=w===a?l:a))}if(g!==E.outputColorSpace||y!==E.toneMapping){g=E.outputColorSpace,y=E.toneMapping,u.defines={},vt.getTransfer(g)===Pt&&(u.defines.SRGB_TRANSFER="");let F=z1[y];F&&(u.defines[F]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=x.texture,E.setRenderTarget(v),E.render(d,m),v=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var Wy=new ni,Xy=new Cs(1,1),qy=new Ia(1),$y=new Ta,Yy=new Sc,Jy=new Pa,Sy=[],wy=[],Ey=new Float32Array(16),Ty=new Float32Array(9),Ay=new Float32Array(4);function Vo(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=Sy[s];if(r===void 0&&(r=new Float32Array(s),Sy[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function Mn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function Sn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Uh(i,e){let t=wy[e];t===void 0&&(t=new Int32Array(e),wy[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function G1(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function H1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Mn(t,e))return;i.uniform2fv(this.addr,e),Sn(t,e)}}function W1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Mn(t,e))return;i.uniform3fv(this.addr,e),Sn(t,e)}}function X1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Mn(t,e))return;i.uniform4fv(this.addr,e),Sn(t,e)}}function q1(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Mn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),Sn(t,e)}else{if(Mn(t,n))return;Ay.set(n),i.uniformMatrix2fv(this.addr,!1,Ay),Sn(t,n)}}function $1(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Mn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),Sn(t,e)}else{if(Mn(t,n))return;Ty.set(n),i.uniformMatrix3fv(this.addr,!1,Ty),Sn(t,n)}}function Y1(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Mn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),Sn(t,e)}else{if(Mn(t,n))return;Ey.set(n),i.uniformMatrix4fv(this.addr,!1,Ey),Sn(t,n)}}function J1(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function Z1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Mn(t,e))return;i.uniform2iv(this.addr,e),Sn(t,e)}}function K1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Mn(t,e))return;i.uniform3iv(this.addr,e),Sn(t,e)}}function j1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Mn(t,e))return;i.uniform4iv(this.addr,e),Sn(t,e)}}function Q1(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function eE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Mn(t,e))return;i.uniform2uiv(this.addr,e),Sn(t,e)}}function tE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Mn(t,e))return;i.uniform3uiv(this.addr,e),Sn(t,e)}}function nE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Mn(t,e))return;i.uniform4uiv(this.addr,e),Sn(t,e)}}function Fh(i){return i.version===0&&(i.compareFunction=xf,i.needsUpdate=!0),i}function iE(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Fh(Xy):r=Wy,t.setTexture2D(e||r,s)}function sE(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||Yy,s)}function rE(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Fh(qy):r=Jy,t.setTextureCube(e||r,s)}function oE(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||$y,s)}function aE(i){switch(i){case 5126:return G1;case 35664:return H1;case 35665:return W1;case 35666:return X1;case 35674:return q1;case 35675:return $1;case 35676:return Y1;case 5124:case 35670:return J1;case 35667:case 35671:return Z1;case 35668:case 35672:return K1;case 35669:case 35673:return j1;case 5125:return Q1;case 36294:return eE;case 36295:return tE;case 36296:return nE;case 35678:case 36198:case 36298:case 36306:case 35682:return iE;case 35679:case 36299:case 36307:return sE;case 35680:case 36300:case 36308:case 36293:return rE;case 36289:case 36303:case 36311:case 36292:return oE}}function lE(i,e){i.uniform1fv(this.addr,e)}function cE(i,e){let t=Vo(e,this.size,2);i.uniform2fv(this.addr,t)}function hE(i,e){let t=Vo(e,this.size,3);i.uniform3fv(this.addr,t)}function uE(i,e){let t=Vo(e,this.size,4);i.uniform4fv(this.addr,t)}function dE(i,e){let t=Vo(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function fE(i,e){let t=Vo(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function pE(i,e){let t=Vo(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function mE(i,e){i.uniform1iv(this.addr,e)}function gE(i,e){i.uniform2iv(this.addr,e)}function yE(i,e){i.uniform3iv(this.addr,e)}function vE(i,e){i.uniform4iv(this.addr,e)}function xE(i,e){i.uniform1uiv(this.addr,e)}function _E(i,e){i.uniform2uiv(this.addr,e)}function bE(i,e){i.uniform3uiv(this.addr,e)}function ME(i,e){i.uniform4uiv(this.addr,e)}function SE(i,e,t){let n=this.cache,s=e.length,r=Uh(t,s);Mn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=Fh(Xy):o=Wy;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function wE(i,e,t){let n=this.cache,s=e.length,r=Uh(t,s);Mn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Yy,r[o])}function EE(i,e,t){let n=this.cache,s=e.length,r=Uh(t,s);Mn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Fh(qy):o=Jy;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function TE(i,e,t){let n=this.cache,s=e.length,r=Uh(t,s);Mn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||$y,r[o])}function AE(i){switch(i){case 5126:return lE;case 35664:return cE;case 35665:return hE;case 35666:return uE;case 35674:return dE;case 35675:return fE;case 35676:return pE;case 5124:case 35670:return mE;case 35667:case 35671:return gE;case 35668:case 35672:return yE;case 35669:case 35673:return vE;case 5125:return xE;case 36294:return _E;case 36295:return bE;case 36296:return ME;case 35678:case 36198:case 36298:case 36306:case 35682:return SE;case 35679:case 36299:case 36307:return wE;case 35680:case 36300:case 36308:case 36293:return EE;case 36289:case 36303:case 36311:case 36292:return TE}}var Rf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=aE(t.type)}},Pf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=AE(t.type)}},If=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},Af=/(\w+)(\])?(\[|\.)?/g;function Cy(i,e){i.seq.push(e),i.map[e.id]=e}function CE(i,e,t){let n=i.name,s=n.length;for(Af.lastIndex=0;;){let r=Af.exec(n),o=Af.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Cy(t,c===void 0?new Rf(a,i,e):new Pf(a,i,e));break}else{let u=t.map[a];u===void 0&&(u=new If(a),Cy(t,u)),t=u}}}var zo=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);CE(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function Ry(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var RE=37297,PE=0;function IE(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var Py=new nt;function LE(i){vt._getMatrix(Py,vt.workingColorSpace,i);let e=`mat3( ${Py.elements.map(t=>t.toFixed(4))} )`;switch(vt.getTransfer(i)){case Sa:return[e,"LinearTransferOETF"];case Pt:return[e,"sRGBTransferOETF"];default:return Ze("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function Iy(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+IE(i.getShaderSource(e),a)}else return r}function NE(i,e){let t=LE(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var DE={[ef]:"Linear",[tf]:"Reinhard",[nf]:"Cineon",[sf]:"ACESFilmic",[of]:"AgX",[af]:"Neutral",[rf]:"Custom"};function UE(i,e){let t=DE[e];return t===void 0?(Ze("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Lh=new V;function FE(){vt.getLuminanceCoefficients(Lh);let i=Lh.x.toFixed(4),e=Lh.y.toFixed(4),t=Lh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function OE(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter($a).join(`
`)}function kE(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function BE(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function $a(i){return i!==""}function Ly(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Ny(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var zE=/^[ \t]*#include +<([\w\d./]+)>/gm;function Lf(i){return i.replace(zE,VE)}function VE(i,e){let t=ht[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Lf(t)}var GE=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Dy(i){return i.replace(GE,HE)}function HE(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Uy(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var WE={[Oa]:"SHADOWMAP_TYPE_PCF",[Fo]:"SHADOWMAP_TYPE_VSM"};function XE(i){return WE[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var qE={[ko]:"ENVMAP_MODE_REFRACTION"};function $E(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":qE[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var YE={[Qd]:"ENVMAP_BLENDING_MULTIPLY",[j0]:"ENVMAP_BLENDING_MIX",[Q0]:"ENVMAP_BLENDING_ADD"};function JE(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":YE[i.combine]||"ENVMAP_BLENDING_NONE"}function ZE(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=XE(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=$E(t),u=JE(t),d=OE(t),m=kE(r),g=s.createProgram(),y,p,f=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(y=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m].filter($a).join(`
`),y.length>0&&(y+=`
`),p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m].filter($a).join(`
`),p.length>0&&(p+=`
`)):(y=[Uy(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter($a).join(`
`),p=[Uy(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==cs?"#define TONE_MAPPING":"",t.toneMapping!==cs?ht.tonemapping_pars_fragment:"",t.toneMapping!==cs?UE("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ht.colorspace_pars_fragment,NE("linearToOutputTexel",t.outputColorSpace),FE(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter($a).join(`
`)),o=Lf(o),o=Ly(o,t),o=Ny(o,t),a=Lf(a),a=Ly(a,t),a=Ny(a,t),o=Dy(o),a=Dy(a),t.isRawShaderMaterial!==!0&&(f=`#version 300 es
`,y=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,p=["#define varying in",t.glslVersion===_f?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===_f?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let v=f+y+o,M=f+p+a,b=Ry(s,s.VERTEX_SHADER,v),E=Ry(s,s.FRAGMENT_SHADER,M);s.attachShader(g,b),s.attachShader(g,E),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function T(N){if(i.debug.checkShaderErrors){let R=s.getProgramInfoLog(g)||"",U=s.getShaderInfoLog(b)||"",k=s.getShaderInfoLog(E)||"",I=R.trim(),H=U.trim(),Y=k.trim(),W=!0,le=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(W=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,b,E);else{let Z=Iy(s,b,"vertex"),q=Iy(s,E,"fragment");tt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+N.name+`
Material Type: `+N.type+`

Program Info Log: `+I+`
`+Z+`
`+q)}else I!==""?Ze("WebGLProgram: Program Info Log:",I):(H===""||Y==="")&&(le=!1);le&&(N.diagnostics={runnable:W,programLog:I,vertexShader:{log:H,prefix:y},fragmentShader:{log:Y,prefix:p}})}s.deleteShader(b),s.deleteShader(E),x=new zo(s,g),w=BE(s,g)}let x;this.getUniforms=function(){return x===void 0&&T(this),x};let w;this.getAttributes=function(){return w===void 0&&T(this),w};let F=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return F===!1&&(F=s.getProgramParameter(g,RE)),F},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=PE++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=b,this.fragmentShader=E,this}var KE=0,Nf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Df(e),t.set(e,n)),n}},Df=class{constructor(e){this.id=KE++,this.code=e,this.usedTimes=0}};function jE(i){return i===ur||i===Ha||i===Wa}function QE(i,e,t,n,s,r){let o=new Aa,a=new Nf,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function m(x){return l.add(x),x===0?"uv":`uv${x}`}function g(x,w,F,N,R,U){let k=N.fog,I=R.geometry,H=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?N.environment:null,Y=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,W=e.get(x.envMap||H,Y),le=d[x.type],Z=n.precision;x.precision!==null&&(Z=n.getMaxPrecision(x.precision),Z!==x.precision&&Ze("WebGLProgram.getParameters:",x.precision,"not supported, using",Z,"instead."));let q=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,te=q!==void 0?q.length:0,ce=0;I.morphAttributes.position!==void 0&&(ce=1),I.morphAttributes.normal!==void 0&&(ce=2),I.morphAttributes.color!==void 0&&(ce=3);let he,Q,me,ge;if(le){let Ce=us[le];he=Ce.vertexShader,Q=Ce.fragmentShader}else{he=x.vertexShader,Q=x.fragmentShader;let Ce=a.getVertexShaderStage(x),at=a.getFragmentShaderStage(x);a.update(x,Ce,at),me=Ce.id,ge=at.id}let Ae=i.getRenderTarget(),Me=i.state.buffers.depth.getReversed(),Xe=R.isInstancedMesh===!0,rt=R.isBatchedMesh===!0,He=!!x.map,ut=!!x.matcap,lt=!!W,it=lt&&W.isPMREMTexture===!0,$t=!!x.aoMap,Bt=!!x.lightMap,ln=!!x.bumpMap&&x.wireframe===!1,Dt=!!x.normalMap,wn=!!x.displacementMap,Mt=!!x.emissiveMap,gn=!!x.metalnessMap,en=!!x.roughnessMap,cn=x.anisotropy>0,z=x.clearcoat>0,Re=x.diffuseRoughness>0,Je=x.dispersion>0,ot=x.retroreflectivity>0,Se=x.iridescence>0,Ft=x.sheen>0,Ve=x.transmission>0,Ye=cn&&!!x.anisotropyMap,P=z&&!!x.clearcoatMap,S=z&&!!x.clearcoatNormalMap,$=z&&!!x.clearcoatRoughnessMap,de=Re&&!!x.diffuseRoughnessMap,oe=Se&&!!x.iridescenceMap,ve=Se&&!!x.iridescenceThicknessMap,xe=Ft&&!!x.sheenColorMap,ne=Ft&&!!x.sheenRoughnessMap,se=!!x.specularMap,pe=!!x.specularColorMap,B=!!x.specularIntensityMap,re=Ve&&!!x.transmissionMap,ie=Ve&&!!x.thicknessMap,we=!!x.gradientMap,ye=!!x.alphaMap,be=x.alphaTest>0,We=!!x.alphaHash,je=!!x.extensions,ue=cs;x.toneMapped&&(Ae===null||Ae.isXRRenderTarget===!0)&&(ue=i.toneMapping);let ke=it?W.isCompressedCubeTexture?W.image[0].mipmaps:W.mipmaps:null,Qe={shaderID:le,shaderType:x.type,shaderName:x.name,vertexShader:he,fragmentShader:Q,defines:x.defines,customVertexShaderID:me,customFragmentShaderID:ge,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:Z,batching:rt,batchingColor:rt&&R._colorsTexture!==null,instancing:Xe,instancingColor:Xe&&R.instanceColor!==null,instancingMorph:Xe&&R.morphTexture!==null,outputColorSpace:Ae===null?i.outputColorSpace:Ae.isXRRenderTarget===!0?Ae.texture.colorSpace:vt.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:He,matcap:ut,envMap:lt,envMapMode:lt&&W.mapping,envMapPMREM:it,envMapMaxLod:it?ke.length-1:null,envMapSize:it?ke[0].width:null,aoMap:$t,lightMap:Bt,bumpMap:ln,normalMap:Dt,displacementMap:wn,emissiveMap:Mt,normalMapObjectSpace:Dt&&x.normalMapType===ny,normalMapTangentSpace:Dt&&x.normalMapType===gf,packedNormalMap:Dt&&x.normalMapType===gf&&jE(x.normalMap.format),metalnessMap:gn,roughnessMap:en,anisotropy:cn,anisotropyMap:Ye,clearcoat:z,clearcoatMap:P,clearcoatNormalMap:S,clearcoatRoughnessMap:$,diffuseRoughness:Re,diffuseRoughnessMap:de,dispersion:Je,retroreflection:ot,iridescence:Se,iridescenceMap:oe,iridescenceThicknessMap:ve,sheen:Ft,sheenColorMap:xe,sheenRoughnessMap:ne,specularMap:se,specularColorMap:pe,specularIntensityMap:B,transmission:Ve,transmissionMap:re,thicknessMap:ie,gradientMap:we,opaque:x.transparent===!1&&x.blending===Oo&&x.alphaToCoverage===!1,alphaMap:ye,alphaTest:be,alphaHash:We,combine:x.combine,mapUv:He&&m(x.map.channel),aoMapUv:$t&&m(x.aoMap.channel),lightMapUv:Bt&&m(x.lightMap.channel),bumpMapUv:ln&&m(x.bumpMap.channel),normalMapUv:Dt&&m(x.normalMap.channel),displacementMapUv:wn&&m(x.displacementMap.channel),emissiveMapUv:Mt&&m(x.emissiveMap.channel),metalnessMapUv:gn&&m(x.metalnessMap.channel),roughnessMapUv:en&&m(x.roughnessMap.channel),anisotropyMapUv:Ye&&m(x.anisotropyMap.channel),clearcoatMapUv:P&&m(x.clearcoatMap.channel),clearcoatNormalMapUv:S&&m(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:$&&m(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:de&&m(x.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&m(x.iridescenceMap.channel),iridescenceThicknessMapUv:ve&&m(x.iridescenceThicknessMap.channel),sheenColorMapUv:xe&&m(x.sheenColorMap.channel),sheenRoughnessMapUv:ne&&m(x.sheenRoughnessMap.channel),specularMapUv:se&&m(x.specularMap.channel),specularColorMapUv:pe&&m(x.specularColorMap.channel),specularIntensityMapUv:B&&m(x.specularIntensityMap.channel),transmissionMapUv:re&&m(x.transmissionMap.channel),thicknessMapUv:ie&&m(x.thicknessMap.channel),alphaMapUv:ye&&m(x.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(Dt||cn),vertexNormals:!!I.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:R.isPoints===!0&&!!I.attributes.uv&&(He||ye),fog:!!k,useFog:x.fog===!0,fogExp2:!!k&&k.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||I.attributes.normal===void 0&&Dt===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:Me,skinning:R.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:te,morphTextureStride:ce,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:U.filter(Ce=>Ce.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:i.shadowMap.enabled&&F.length>0,shadowMapType:i.shadowMap.type,toneMapping:ue,decodeVideoTexture:He&&x.map.isVideoTexture===!0&&vt.getTransfer(x.map.colorSpace)===Pt,decodeVideoTextureEmissive:Mt&&x.emissiveMap.isVideoTexture===!0&&vt.getTransfer(x.emissiveMap.colorSpace)===Pt,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===ls,flipSided:x.side===ti,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:je&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(je&&x.extensions.multiDraw===!0||rt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return Qe.vertexUv1s=l.has(1),Qe.vertexUv2s=l.has(2),Qe.vertexUv3s=l.has(3),l.clear(),Qe}function y(x){let w=[];if(x.shaderID?w.push(x.shaderID):(w.push(x.customVertexShaderID),w.push(x.customFragmentShaderID)),x.defines!==void 0)for(let F in x.defines)w.push(F),w.push(x.defines[F]);return x.isRawShaderMaterial===!1&&(p(w,x),f(w,x),w.push(i.outputColorSpace)),w.push(x.customProgramCacheKey),w.join()}function p(x,w){x.push(w.precision),x.push(w.outputColorSpace),x.push(w.envMapMode),x.push(w.envMapPMREM),x.push(w.envMapMaxLod),x.push(w.envMapSize),x.push(w.mapUv),x.push(w.alphaMapUv),x.push(w.lightMapUv),x.push(w.aoMapUv),x.push(w.bumpMapUv),x.push(w.normalMapUv),x.push(w.displacementMapUv),x.push(w.emissiveMapUv),x.push(w.metalnessMapUv),x.push(w.roughnessMapUv),x.push(w.anisotropyMapUv),x.push(w.clearcoatMapUv),x.push(w.clearcoatNormalMapUv),x.push(w.clearcoatRoughnessMapUv),x.push(w.diffuseRoughnessMapUv),x.push(w.iridescenceMapUv),x.push(w.iridescenceThicknessMapUv),x.push(w.sheenColorMapUv),x.push(w.sheenRoughnessMapUv),x.push(w.specularMapUv),x.push(w.specularColorMapUv),x.push(w.specularIntensityMapUv),x.push(w.transmissionMapUv),x.push(w.thicknessMapUv),x.push(w.combine),x.push(w.fogExp2),x.push(w.sizeAttenuation),x.push(w.morphTargetsCount),x.push(w.numSunLights),x.push(w.numDirLights),x.push(w.numPointLights),x.push(w.numSpotLights),x.push(w.numSpotLightMaps),x.push(w.numHemiLights),x.push(w.numRectAreaLights),x.push(w.numSunLightShadows),x.push(w.numDirLightShadows),x.push(w.numPointLightShadows),x.push(w.numSpotLightShadows),x.push(w.numSpotLightShadowsWithMaps),x.push(w.numLightProbes),x.push(w.numLightProbeGrids),x.push(w.shadowMapType),x.push(w.toneMapping),x.push(w.numClippingPlanes),x.push(w.numClipIntersection),x.push(w.depthPacking)}function f(x,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function v(x){let w=d[x.type],F;if(w){let N=us[w];F=gy.clone(N.uniforms)}else F=x.uniforms;return F}function M(x,w){let F=h.get(w);return F!==void 0?++F.usedTimes:(F=new ZE(i,w,x,s),c.push(F),h.set(w,F)),F}function b(x){if(--x.usedTimes===0){let w=c.indexOf(x);c[w]=c[c.length-1],c.pop(),h.delete(x.cacheKey),x.destroy()}}function E(x){a.remove(x)}function T(){a.dispose()}return{getParameters:g,getProgramCacheKey:y,getUniforms:v,acquireProgram:M,releaseProgram:b,releaseShaderCache:E,programs:c,dispose:T}}function eT(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function tT(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function Fy(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function Oy(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(d){let m=0;return d.isInstancedMesh&&(m+=2),d.isSkinnedMesh&&(m+=1),m}function a(d,m,g,y,p,f){let v=i[e];return v===void 0?(v={id:d.id,object:d,geometry:m,material:g,materialVariant:o(d),groupOrder:y,renderOrder:d.renderOrder,z:p,group:f},i[e]=v):(v.id=d.id,v.object=d,v.geometry=m,v.material=g,v.materialVariant=o(d),v.groupOrder=y,v.renderOrder=d.renderOrder,v.z=p,v.group=f),e++,v}function l(d,m,g,y,p,f,v){v.reversedDepth===!0&&(p=-p);let M=a(d,m,g,y,p,f);g.transmission>0?n.push(M):g.transparent===!0?s.push(M):t.push(M)}function c(d,m,g,y,p,f){let v=a(d,m,g,y,p,f);g.transmission>0?n.unshift(v):g.transparent===!0?s.unshift(v):t.unshift(v)}function h(d,m){t.length>1&&t.sort(d||tT),n.length>1&&n.sort(m||Fy),s.length>1&&s.sort(m||Fy)}function u(){for(let d=e,m=i.length;d<m;d++){let g=i[d];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function nT(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new Oy,i.set(n,[o])):s>=r.length?(o=new Oy,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function iT(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new V,color:new bt};break;case"SpotLight":t={position:new V,direction:new V,color:new bt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new V,color:new bt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new V,skyColor:new bt,groundColor:new bt};break;case"RectAreaLight":t={color:new bt,position:new V,halfWidth:new V,halfHeight:new V};break}return i[e.id]=t,t}}}function sT(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new _t};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new _t};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new _t,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var rT=0;function oT(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function aT(i){let e=new iT,t=sT(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new V);let s=new V,r=new zt,o=new zt;function a(c){let h=0,u=0,d=0;for(let U=0;U<9;U++)n.probe[U].set(0,0,0);let m=0,g=0,y=0,p=0,f=0,v=0,M=0,b=0,E=0,T=0,x=0,w=0,F=0,N=0;c.sort(oT);for(let U=0,k=c.length;U<k;U++){let I=c[U],H=I.color,Y=I.intensity,W=I.distance,le=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===ur?le=I.shadow.map.texture:le=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)h+=H.r*Y,u+=H.g*Y,d+=H.b*Y;else if(I.isLightProbe){for(let Z=0;Z<9;Z++)n.probe[Z].addScaledVector(I.sh.coefficients[Z],Y);N++}else if(I.isSunLight){let Z=e.get(I);if(Z.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let q=I.shadow,te=t.get(I);te.shadowIntensity=q.intensity,te.shadowBias=q.bias,te.shadowNormalBias=q.normalBias,te.shadowRadius=q.radius,te.shadowMapSize.copy(q.mapSize).multiply(q.getFrameExtents()),n.sunShadow[g]=te,n.sunShadowMap[g]=le;let ce=q.getViewportCount();for(let he=0;he<ce;he++)n.sunShadowMatrix[y+he]=q.getMatrix(he),n.sunShadowCascade[y+he]=q._cascadeData[he];y+=ce,g++}n.sun[m]=Z,m++}else if(I.isDirectionalLight){let Z=e.get(I);if(Z.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let q=I.shadow,te=t.get(I);te.shadowIntensity=q.intensity,te.shadowBias=q.bias,te.shadowNormalBias=q.normalBias,te.shadowRadius=q.radius,te.shadowMapSize=q.mapSize,n.directionalShadow[p]=te,n.directionalShadowMap[p]=le,n.directionalShadowMatrix[p]=I.shadow.matrix,E++}n.directional[p]=Z,p++}else if(I.isSpotLight){let Z=e.get(I);Z.position.setFromMatrixPosition(I.matrixWorld),Z.color.copy(H).multiplyScalar(Y),Z.distance=W,Z.coneCos=Math.cos(I.angle),Z.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),Z.decay=I.decay,n.spot[v]=Z;let q=I.shadow;if(I.map&&(n.spotLightMap[w]=I.map,w++,q.updateMatrices(I),I.castShadow&&F++),n.spotLightMatrix[v]=q.matrix,I.castShadow){let te=t.get(I);te.shadowIntensity=q.intensity,te.shadowBias=q.bias,te.shadowNormalBias=q.normalBias,te.shadowRadius=q.radius,te.shadowMapSize=q.mapSize,n.spotShadow[v]=te,n.spotShadowMap[v]=le,x++}v++}else if(I.isRectAreaLight){let Z=e.get(I);Z.color.copy(H).multiplyScalar(Y),Z.halfWidth.set(I.width*.5,0,0),Z.halfHeight.set(0,I.height*.5,0),n.rectArea[M]=Z,M++}else if(I.isPointLight){let Z=e.get(I);if(Z.color.copy(I.color).multiplyScalar(I.intensity),Z.distance=I.distance,Z.decay=I.decay,I.castShadow){let q=I.shadow,te=t.get(I);te.shadowIntensity=q.intensity,te.shadowBias=q.bias,te.shadowNormalBias=q.normalBias,te.shadowRadius=q.radius,te.shadowMapSize=q.mapSize,te.shadowCameraNear=q.camera.near,te.shadowCameraFar=q.camera.far,n.pointShadow[f]=te,n.pointShadowMap[f]=le,n.pointShadowMatrix[f]=I.shadow.matrix,T++}n.point[f]=Z,f++}else if(I.isHemisphereLight){let Z=e.get(I);Z.skyColor.copy(I.color).multiplyScalar(Y),Z.groundColor.copy(I.groundColor).multiplyScalar(Y),n.hemi[b]=Z,b++}}M>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Ne.LTC_FLOAT_1,n.rectAreaLTC2=Ne.LTC_FLOAT_2):(n.rectAreaLTC1=Ne.LTC_HALF_1,n.rectAreaLTC2=Ne.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;let R=n.hash;(R.sunLength!==m||R.directionalLength!==p||R.pointLength!==f||R.spotLength!==v||R.rectAreaLength!==M||R.hemiLength!==b||R.numSunShadows!==g||R.numDirectionalShadows!==E||R.numPointShadows!==T||R.numSpotShadows!==x||R.numSpotMaps!==w||R.numLightProbes!==N)&&(n.sun.length=m,n.directional.length=p,n.spot.length=v,n.rectArea.length=M,n.point.length=f,n.hemi.length=b,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=y,n.sunShadowCascade.length=y,n.directionalShadow.length=E,n.directionalShadowMap.length=E,n.directionalShadowMatrix.length=E,n.pointShadow.length=T,n.pointShadowMap.length=T,n.pointShadowMatrix.length=T,n.spotShadow.length=x,n.spotShadowMap.length=x,n.spotLightMatrix.length=x+w-F,n.spotLightMap.length=w,n.numSpotLightShadowsWithMaps=F,n.numLightProbes=N,R.sunLength=m,R.directionalLength=p,R.pointLength=f,R.spotLength=v,R.rectAreaLength=M,R.hemiLength=b,R.numSunShadows=g,R.numDirectionalShadows=E,R.numPointShadows=T,R.numSpotShadows=x,R.numSpotMaps=w,R.numLightProbes=N,n.version=rT++)}function l(c,h){let u=0,d=0,m=0,g=0,y=0,p=0,f=h.matrixWorldInverse;for(let v=0,M=c.length;v<M;v++){let b=c[v];if(b.isSunLight){let E=n.sun[u];E.direction.setFromMatrixPosition(b.matrixWorld),E.direction.transformDirection(f),u++}else if(b.isDirectionalLight){let E=n.directional[d];E.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),E.direction.sub(s),E.direction.transformDirection(f),d++}else if(b.isSpotLight){let E=n.spot[g];E.position.setFromMatrixPosition(b.matrixWorld),E.position.applyMatrix4(f),E.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),E.direction.sub(s),E.direction.transformDirection(f),g++}else if(b.isRectAreaLight){let E=n.rectArea[y];E.position.setFromMatrixPosition(b.matrixWorld),E.position.applyMatrix4(f),o.identity(),r.copy(b.matrixWorld),r.premultiply(f),o.extractRotation(r),E.halfWidth.set(b.width*.5,0,0),E.halfHeight.set(0,b.height*.5,0),E.halfWidth.applyMatrix4(o),E.halfHeight.applyMatrix4(o),y++}else if(b.isPointLight){let E=n.point[m];E.position.setFromMatrixPosition(b.matrixWorld),E.position.applyMatrix4(f),m++}else if(b.isHemisphereLight){let E=n.hemi[p];E.direction.setFromMatrixPosition(b.matrixWorld),E.direction.transformDirection(f),p++}}}return{setup:a,setupView:l,state:n}}function ky(i){let e=new aT(i),t=[],n=[],s=[];function r(u){h.camera=u,t.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):t.push(u)}function a(u){n.push(u)}function l(){e.setup(t),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){e.setupView(t,u)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function lT(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new ky(i),e.set(s,[a])):r>=o.length?(a=new ky(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var cT=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,hT=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,uT=[new V(1,0,0),new V(-1,0,0),new V(0,1,0),new V(0,-1,0),new V(0,0,1),new V(0,0,-1)],dT=[new V(0,-1,0),new V(0,-1,0),new V(0,0,1),new V(0,0,-1),new V(0,-1,0),new V(0,-1,0)],By=new zt,qa=new V,Cf=new V;function fT(i,e,t){let n=new Rr,s=new _t,r=new _t,o=new Qt,a=new Lc,l=new Nc,c={},h=t.maxTextureSize,u={[hr]:ti,[ti]:hr,[ls]:ls},d=new Un({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new _t},radius:{value:4}},vertexShader:cT,fragmentShader:hT}),m=d.clone();m.defines.HORIZONTAL_PASS=1;let g=new In;g.setAttribute("position",new Vn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new Kt(g,d),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Oa;let f=this.type;this.render=function(T,x,w){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||T.length===0)return;this.type===N0&&(Ze("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Oa);let F=i.getRenderTarget(),N=i.getActiveCubeFace(),R=i.getActiveMipmapLevel(),U=i.state;U.setBlending(Pr),U.buffers.depth.getReversed()===!0?U.buffers.color.setClear(0,0,0,0):U.buffers.color.setClear(1,1,1,1),U.buffers.depth.setTest(!0),U.setScissorTest(!1);let k=f!==this.type;k&&x.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(H=>H.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,H=T.length;I<H;I++){let Y=T[I],W=Y.shadow;if(W===void 0){Ze("WebGLShadowMap:",Y,"has no shadow.");continue}if(W.autoUpdate===!1&&W.needsUpdate===!1)continue;s.copy(W.mapSize);let le=W.getFrameExtents();s.multiply(le),r.copy(W.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/le.x),s.x=r.x*le.x,W.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/le.y),s.y=r.y*le.y,W.mapSize.y=r.y));let Z=i.state.buffers.depth.getReversed();if(W.camera._reversedDepth=Z,W.map===null||k===!0){if(W.map!==null&&(W.map.depthTexture!==null&&(W.map.depthTexture.dispose(),W.map.depthTexture=null),W.map.dispose()),this.type===Fo){if(Y.isPointLight){Ze("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}W.map=new ei(s.x,s.y,{format:ur,type:Gi,minFilter:Dn,magFilter:Dn,generateMipmaps:!1}),W.map.texture.name=Y.name+".shadowMap",W.map.depthTexture=new Cs(s.x,s.y,Vi),W.map.depthTexture.name=Y.name+".shadowMapDepth",W.map.depthTexture.format=Ts,W.map.depthTexture.compareFunction=null,W.map.depthTexture.minFilter=Pn,W.map.depthTexture.magFilter=Pn}else Y.isPointLight?(W.map=new Ya(s.x),W.map.depthTexture=new Ia(s.x,zi)):(W.map=new ei(s.x,s.y),W.map.depthTexture=new Cs(s.x,s.y,zi)),W.map.depthTexture.name=Y.name+".shadowMap",W.map.depthTexture.format=Ts,this.type===Oa?(W.map.depthTexture.compareFunction=Z?vf:yf,W.map.depthTexture.minFilter=Dn,W.map.depthTexture.magFilter=Dn):(W.map.depthTexture.compareFunction=null,W.map.depthTexture.minFilter=Pn,W.map.depthTexture.magFilter=Pn);W.camera.updateProjectionMatrix()}W.map.isWebGLCubeRenderTarget!==!0&&(W.map.width!==s.x||W.map.height!==s.y)&&W.map.setSize(s.x,s.y);let q=W.map.isWebGLCubeRenderTarget?6:W.getViewportCount();Y.isPointLight!==!0&&W.updateMatrices(Y,w);let te=(W.camera.layers.mask&4294967294)!==0?W.camera.layers:w.layers;for(let ce=0;ce<q;ce++){let he=W.getCamera(ce);if(Y.isPointLight){let Q=W.camera,me=W.matrix,ge=Y.distance||Q.far;ge!==Q.far&&(Q.far=ge,Q.updateProjectionMatrix()),qa.setFromMatrixPosition(Y.matrixWorld),Q.position.copy(qa),Cf.copy(Q.position),Cf.add(uT[ce]),Q.up.copy(dT[ce]),Q.lookAt(Cf),Q.updateMatrixWorld(),me.makeTranslation(-qa.x,-qa.y,-qa.z),By.multiplyMatrices(Q.projectionMatrix,Q.matrixWorldInverse),W._frustum.setFromProjectionMatrix(By,Q.coordinateSystem,Q.reversedDepth)}if(W.map.isWebGLCubeRenderTarget)i.setRenderTarget(W.map,ce),i.clear();else{ce===0&&(i.setRenderTarget(W.map),i.clear());let Q=W.getViewport(ce);o.set(r.x*Q.x,r.y*Q.y,r.x*Q.z,r.y*Q.w),U.viewport(o)}n=W.getFrustum(ce),b(x,w,he,Y,te,this.type)}W.isPointLightShadow!==!0&&this.type===Fo&&v(W,w),W.needsUpdate=!1}f=this.type,p.needsUpdate=!1,i.setRenderTarget(F,N,R)};function v(T,x){let w=e.update(y);d.defines.VSM_SAMPLES!==T.blurSamples&&(d.defines.VSM_SAMPLES=T.blurSamples,m.defines.VSM_SAMPLES=T.blurSamples,d.needsUpdate=!0,m.needsUpdate=!0),T.mapPass===null?T.mapPass=new ei(s.x,s.y,{format:ur,type:Gi}):(T.mapPass.width!==T.map.width||T.mapPass.height!==T.map.height)&&T.mapPass.setSize(T.map.width,T.map.height),d.uniforms.shadow_pass.value=T.map.depthTexture,d.uniforms.resolution.value.set(T.map.width,T.map.height),d.uniforms.radius.value=T.radius,i.setRenderTarget(T.mapPass),i.clear(),i.renderBufferDirect(x,null,w,d,y,null),m.uniforms.shadow_pass.value=T.mapPass.texture,m.uniforms.resolution.value.set(T.map.width,T.map.height),m.uniforms.radius.value=T.radius,i.setRenderTarget(T.map),i.clear(),i.renderBufferDirect(x,null,w,m,y,null)}function M(T,x,w,F){let N=null,R=w.isPointLight===!0?T.customDistanceMaterial:T.customDepthMaterial;if(R!==void 0)N=R;else if(N=w.isPointLight===!0?l:a,i.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let U=N.uuid,k=x.uuid,I=c[U];I===void 0&&(I={},c[U]=I);let H=I[k];H===void 0&&(H=N.clone(),I[k]=H,x.addEventListener("dispose",E)),N=H}if(N.visible=x.visible,N.wireframe=x.wireframe,F===Fo?N.side=x.shadowSide!==null?x.shadowSide:x.side:N.side=x.shadowSide!==null?x.shadowSide:u[x.side],N.alphaMap=x.alphaMap,N.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,N.map=x.map,N.clipShadows=x.clipShadows,N.clippingPlanes=x.clippingPlanes,N.clipIntersection=x.clipIntersection,N.displacementMap=x.displacementMap,N.displacementScale=x.displacementScale,N.displacementBias=x.displacementBias,N.wireframeLinewidth=x.wireframeLinewidth,N.linewidth=x.linewidth,w.isPointLight===!0&&N.isMeshDistanceMaterial===!0){let U=i.properties.get(N);U.light=w}return N}function b(T,x,w,F,N,R){if(T.visible===!1)return;if(T.layers.test(N)&&(T.isMesh||T.isLine||T.isPoints)&&(T.castShadow||T.receiveShadow&&R===Fo)&&(!T.frustumCulled||T.intersectsFrustum(n))){T.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,T.matrixWorld);let I=e.update(T),H=T.material;if(Array.isArray(H)){let Y=I.groups;for(let W=0,le=Y.length;W<le;W++){let Z=Y[W],q=H[Z.materialIndex];if(q&&q.visible){let te=M(T,q,F,R);T.onBeforeShadow(i,T,x,w,I,te,Z),i.renderBufferDirect(w,null,I,te,T,Z),T.onAfterShadow(i,T,x,w,I,te,Z)}}}else if(H.visible){let Y=M(T,H,F,R);T.onBeforeShadow(i,T,x,w,I,Y,null),i.renderBufferDirect(w,null,I,Y,T,null),T.onAfterShadow(i,T,x,w,I,Y,null)}}let k=T.children;for(let I=0,H=k.length;I<H;I++)b(k[I],x,w,F,N,R)}function E(T){T.target.removeEventListener("dispose",E);for(let w in c){let F=c[w],N=T.target.uuid;N in F&&(F[N].dispose(),delete F[N])}}}function pT(i,e){function t(){let B=!1,re=new Qt,ie=null,we=new Qt(0,0,0,0);return{setMask:function(ye){ie!==ye&&!B&&(i.colorMask(ye,ye,ye,ye),ie=ye)},setLocked:function(ye){B=ye},setClear:function(ye,be,We,je,ue){ue===!0&&(ye*=je,be*=je,We*=je),re.set(ye,be,We,je),we.equals(re)===!1&&(i.clearColor(ye,be,We,je),we.copy(re))},reset:function(){B=!1,ie=null,we.set(-1,0,0,0)}}}function n(){let B=!1,re=!1,ie=null,we=null,ye=null;return{setReversed:function(be){if(re!==be){let We=e.get("EXT_clip_control");be?We.clipControlEXT(We.LOWER_LEFT_EXT,We.ZERO_TO_ONE_EXT):We.clipControlEXT(We.LOWER_LEFT_EXT,We.NEGATIVE_ONE_TO_ONE_EXT),re=be;let je=ye;ye=null,this.setClear(je)}},getReversed:function(){return re},setTest:function(be){be?Me(i.DEPTH_TEST):Xe(i.DEPTH_TEST)},setMask:function(be){ie!==be&&!B&&(i.depthMask(be),ie=be)},setFunc:function(be){if(re&&(be=fy[be]),we!==be){switch(be){case uc:i.depthFunc(i.NEVER);break;case dc:i.depthFunc(i.ALWAYS);break;case fc:i.depthFunc(i.LESS);break;case Eo:i.depthFunc(i.LEQUAL);break;case pc:i.depthFunc(i.EQUAL);break;case mc:i.depthFunc(i.GEQUAL);break;case To:i.depthFunc(i.GREATER);break;case gc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}we=be}},setLocked:function(be){B=be},setClear:function(be){ye!==be&&(ye=be,re&&(be=1-be),i.clearDepth(be))},reset:function(){B=!1,ie=null,we=null,ye=null,re=!1}}}function s(){let B=!1,re=null,ie=null,we=null,ye=null,be=null,We=null,je=null,ue=null;return{setTest:function(ke){B||(ke?Me(i.STENCIL_TEST):Xe(i.STENCIL_TEST))},setMask:function(ke){re!==ke&&!B&&(i.stencilMask(ke),re=ke)},setFunc:function(ke,Qe,Ce){(ie!==ke||we!==Qe||ye!==Ce)&&(i.stencilFunc(ke,Qe,Ce),ie=ke,we=Qe,ye=Ce)},setOp:function(ke,Qe,Ce){(be!==ke||We!==Qe||je!==Ce)&&(i.stencilOp(ke,Qe,Ce),be=ke,We=Qe,je=Ce)},setLocked:function(ke){B=ke},setClear:function(ke){ue!==ke&&(i.clearStencil(ke),ue=ke)},reset:function(){B=!1,re=null,ie=null,we=null,ye=null,be=null,We=null,je=null,ue=null}}}let r=new t,o=new n,a=new s,l={},c=new WeakMap,h={},u={},d={},m=new WeakMap,g=[],y=null,p=!1,f=null,v=null,M=null,b=null,E=null,T=null,x=null,w=new bt(0,0,0),F=0,N=!1,R=null,U=null,k=null,I=null,H=null,Y=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),W=!1,le=0,Z=i.getParameter(i.VERSION);Z.indexOf("WebGL")!==-1?(le=parseFloat(/^WebGL (\d)/.exec(Z)[1]),W=le>=1):Z.indexOf("OpenGL ES")!==-1&&(le=parseFloat(/^OpenGL ES (\d)/.exec(Z)[1]),W=le>=2);let q=null,te={},ce=i.getParameter(i.SCISSOR_BOX),he=i.getParameter(i.VIEWPORT),Q=new Qt().fromArray(ce),me=new Qt().fromArray(he);function ge(B,re,ie,we){let ye=new Uint8Array(4),be=i.createTexture();i.bindTexture(B,be),i.texParameteri(B,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(B,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let We=0;We<ie;We++)B===i.TEXTURE_3D||B===i.TEXTURE_2D_ARRAY?i.texImage3D(re,0,i.RGBA,1,1,we,0,i.RGBA,i.UNSIGNED_BYTE,ye):i.texImage2D(re+We,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,ye);return be}let Ae={};Ae[i.TEXTURE_2D]=ge(i.TEXTURE_2D,i.TEXTURE_2D,1),Ae[i.TEXTURE_CUBE_MAP]=ge(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ae[i.TEXTURE_2D_ARRAY]=ge(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Ae[i.TEXTURE_3D]=ge(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Me(i.DEPTH_TEST),o.setFunc(Eo),ln(!1),Dt($d),Me(i.CULL_FACE),$t(Pr);function Me(B){h[B]!==!0&&(i.enable(B),h[B]=!0)}function Xe(B){h[B]!==!1&&(i.disable(B),h[B]=!1)}function rt(B,re){return d[B]!==re?(i.bindFramebuffer(B,re),d[B]=re,B===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=re),B===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=re),!0):!1}function He(B,re){let ie=g,we=!1;if(B){ie=m.get(re),ie===void 0&&(ie=[],m.set(re,ie));let ye=B.textures;if(ie.length!==ye.length||ie[0]!==i.COLOR_ATTACHMENT0){for(let be=0,We=ye.length;be<We;be++)ie[be]=i.COLOR_ATTACHMENT0+be;ie.length=ye.length,we=!0}}else ie[0]!==i.BACK&&(ie[0]=i.BACK,we=!0);we&&i.drawBuffers(ie)}function ut(B){return y!==B?(i.useProgram(B),y=B,!0):!1}let lt={[Ir]:i.FUNC_ADD,[U0]:i.FUNC_SUBTRACT,[F0]:i.FUNC_REVERSE_SUBTRACT};lt[O0]=i.MIN,lt[k0]=i.MAX;let it={[B0]:i.ZERO,[z0]:i.ONE,[V0]:i.SRC_COLOR,[Kd]:i.SRC_ALPHA,[$0]:i.SRC_ALPHA_SATURATE,[X0]:i.DST_COLOR,[H0]:i.DST_ALPHA,[G0]:i.ONE_MINUS_SRC_COLOR,[jd]:i.ONE_MINUS_SRC_ALPHA,[q0]:i.ONE_MINUS_DST_COLOR,[W0]:i.ONE_MINUS_DST_ALPHA,[Y0]:i.CONSTANT_COLOR,[J0]:i.ONE_MINUS_CONSTANT_COLOR,[Z0]:i.CONSTANT_ALPHA,[K0]:i.ONE_MINUS_CONSTANT_ALPHA};function $t(B,re,ie,we,ye,be,We,je,ue,ke){if(B===Pr){p===!0&&(Xe(i.BLEND),p=!1);return}if(p===!1&&(Me(i.BLEND),p=!0),B!==D0){if(B!==f||ke!==N){if((v!==Ir||E!==Ir)&&(i.blendEquation(i.FUNC_ADD),v=Ir,E=Ir),ke)switch(B){case Oo:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Yd:i.blendFunc(i.ONE,i.ONE);break;case Jd:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Zd:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:tt("WebGLState: Invalid blending: ",B);break}else switch(B){case Oo:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Yd:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Jd:tt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Zd:tt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:tt("WebGLState: Invalid blending: ",B);break}M=null,b=null,T=null,x=null,w.set(0,0,0),F=0,f=B,N=ke}return}ye=ye||re,be=be||ie,We=We||we,(re!==v||ye!==E)&&(i.blendEquationSeparate(lt[re],lt[ye]),v=re,E=ye),(ie!==M||we!==b||be!==T||We!==x)&&(i.blendFuncSeparate(it[ie],it[we],it[be],it[We]),M=ie,b=we,T=be,x=We),(je.equals(w)===!1||ue!==F)&&(i.blendColor(je.r,je.g,je.b,ue),w.copy(je),F=ue),f=B,N=!1}function Bt(B,re){B.side===ls?Xe(i.CULL_FACE):Me(i.CULL_FACE);let ie=B.side===ti;re&&(ie=!ie),ln(ie),B.blending===Oo&&B.transparent===!1?$t(Pr):$t(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),o.setFunc(B.depthFunc),o.setTest(B.depthTest),o.setMask(B.depthWrite),r.setMask(B.colorWrite);let we=B.stencilWrite;a.setTest(we),we&&(a.setMask(B.stencilWriteMask),a.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),a.setOp(B.stencilFail,B.stencilZFail,B.stencilZPass)),Mt(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?Me(i.SAMPLE_ALPHA_TO_COVERAGE):Xe(i.SAMPLE_ALPHA_TO_COVERAGE)}function ln(B){R!==B&&(B?i.frontFace(i.CW):i.frontFace(i.CCW),R=B)}function Dt(B){B!==I0?(Me(i.CULL_FACE),B!==U&&(B===$d?i.cullFace(i.BACK):B===L0?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Xe(i.CULL_FACE),U=B}function wn(B){B!==k&&(W&&i.lineWidth(B),k=B)}function Mt(B,re,ie){B?(Me(i.POLYGON_OFFSET_FILL),(I!==re||H!==ie)&&(I=re,H=ie,o.getReversed()&&(re=-re,ie=-ie),i.polygonOffset(re,ie))):Xe(i.POLYGON_OFFSET_FILL)}function gn(B){B?Me(i.SCISSOR_TEST):Xe(i.SCISSOR_TEST)}function en(B){B===void 0&&(B=i.TEXTURE0+Y-1),q!==B&&(i.activeTexture(B),q=B)}function cn(B,re,ie){ie===void 0&&(q===null?ie=i.TEXTURE0+Y-1:ie=q);let we=te[ie];we===void 0&&(we={type:void 0,texture:void 0},te[ie]=we),(we.type!==B||we.texture!==re)&&(q!==ie&&(i.activeTexture(ie),q=ie),i.bindTexture(B,re||Ae[B]),we.type=B,we.texture=re)}function z(){let B=te[q];B!==void 0&&B.type!==void 0&&(i.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function Re(){try{i.compressedTexImage2D(...arguments)}catch(B){tt("WebGLState:",B)}}function Je(){try{i.compressedTexImage3D(...arguments)}catch(B){tt("WebGLState:",B)}}function ot(){try{i.texSubImage2D(...arguments)}catch(B){tt("WebGLState:",B)}}function Se(){try{i.texSubImage3D(...arguments)}catch(B){tt("WebGLState:",B)}}function Ft(){try{i.compressedTexSubImage2D(...arguments)}catch(B){tt("WebGLState:",B)}}function Ve(){try{i.compressedTexSubImage3D(...arguments)}catch(B){tt("WebGLState:",B)}}function Ye(){try{i.texStorage2D(...arguments)}catch(B){tt("WebGLState:",B)}}function P(){try{i.texStorage3D(...arguments)}catch(B){tt("WebGLState:",B)}}function S(){try{i.texImage2D(...arguments)}catch(B){tt("WebGLState:",B)}}function $(){try{i.texImage3D(...arguments)}catch(B){tt("WebGLState:",B)}}function de(B){return u[B]!==void 0?u[B]:i.getParameter(B)}function oe(B,re){u[B]!==re&&(i.pixelStorei(B,re),u[B]=re)}function ve(B){Q.equals(B)===!1&&(i.scissor(B.x,B.y,B.z,B.w),Q.copy(B))}function xe(B){me.equals(B)===!1&&(i.viewport(B.x,B.y,B.z,B.w),me.copy(B))}function ne(B,re){let ie=c.get(re);ie===void 0&&(ie=new WeakMap,c.set(re,ie));let we=ie.get(B);we===void 0&&(we=i.getUniformBlockIndex(re,B.name),i.uniformBlockBinding(re,we,we),ie.set(B,we))}function se(B,re,ie){let ye=c.get(re).get(B);l[ye]!==ie&&(i.bindBufferBase(i.UNIFORM_BUFFER,ye,ie),l[ye]=ie)}function pe(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},q=null,te={},d={},l={},m=new WeakMap,g=[],y=null,p=!1,f=null,v=null,M=null,b=null,E=null,T=null,x=null,w=new bt(0,0,0),F=0,N=!1,R=null,U=null,k=null,I=null,H=null,Q.set(0,0,i.canvas.width,i.canvas.height),me.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Me,disable:Xe,bindFramebuffer:rt,drawBuffers:He,useProgram:ut,setBlending:$t,setMaterial:Bt,setFlipSided:ln,setCullFace:Dt,setLineWidth:wn,setPolygonOffset:Mt,setScissorTest:gn,activeTexture:en,bindTexture:cn,unbindTexture:z,compressedTexImage2D:Re,compressedTexImage3D:Je,texImage2D:S,texImage3D:$,pixelStorei:oe,getParameter:de,updateUBOMapping:ne,uniformBlockBinding:se,texStorage2D:Ye,texStorage3D:P,texSubImage2D:ot,texSubImage3D:Se,compressedTexSubImage2D:Ft,compressedTexSubImage3D:Ve,scissor:ve,viewport:xe,reset:pe}}function mT(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new _t,h=new WeakMap,u=new Set,d,m=new WeakMap,g=new Set,y=new FinalizationRegistry(P=>g.delete(P)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function f(P,S){return p?new OffscreenCanvas(P,S):Ea("canvas")}function v(P,S,$){let de=1,oe=Ye(P);if((oe.width>$||oe.height>$)&&(de=$/Math.max(oe.width,oe.height)),de<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){let ve=Math.floor(de*oe.width),xe=Math.floor(de*oe.height);d===void 0&&(d=f(ve,xe));let ne=S?f(ve,xe):d;return ne.width=ve,ne.height=xe,ne.getContext("2d").drawImage(P,0,0,ve,xe),Ze("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+ve+"x"+xe+")."),ne}else return"data"in P&&Ze("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),P;return P}function M(P){return P.generateMipmaps}function b(P){i.generateMipmap(P)}function E(P){return P.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?i.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function T(P,S,$,de,oe,ve=!1){if(P!==null){if(i[P]!==void 0)return i[P];Ze("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let xe;de&&(xe=e.get("EXT_texture_norm16"),xe||Ze("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ne=S;if(S===i.RED&&($===i.FLOAT&&(ne=i.R32F),$===i.HALF_FLOAT&&(ne=i.R16F),$===i.UNSIGNED_BYTE&&(ne=i.R8),$===i.UNSIGNED_SHORT&&xe&&(ne=xe.R16_EXT),$===i.SHORT&&xe&&(ne=xe.R16_SNORM_EXT)),S===i.RED_INTEGER&&($===i.UNSIGNED_BYTE&&(ne=i.R8UI),$===i.UNSIGNED_SHORT&&(ne=i.R16UI),$===i.UNSIGNED_INT&&(ne=i.R32UI),$===i.BYTE&&(ne=i.R8I),$===i.SHORT&&(ne=i.R16I),$===i.INT&&(ne=i.R32I)),S===i.RG&&($===i.FLOAT&&(ne=i.RG32F),$===i.HALF_FLOAT&&(ne=i.RG16F),$===i.UNSIGNED_BYTE&&(ne=i.RG8),$===i.UNSIGNED_SHORT&&xe&&(ne=xe.RG16_EXT),$===i.SHORT&&xe&&(ne=xe.RG16_SNORM_EXT)),S===i.RG_INTEGER&&($===i.UNSIGNED_BYTE&&(ne=i.RG8UI),$===i.UNSIGNED_SHORT&&(ne=i.RG16UI),$===i.UNSIGNED_INT&&(ne=i.RG32UI),$===i.BYTE&&(ne=i.RG8I),$===i.SHORT&&(ne=i.RG16I),$===i.INT&&(ne=i.RG32I)),S===i.RGB_INTEGER&&($===i.UNSIGNED_BYTE&&(ne=i.RGB8UI),$===i.UNSIGNED_SHORT&&(ne=i.RGB16UI),$===i.UNSIGNED_INT&&(ne=i.RGB32UI),$===i.BYTE&&(ne=i.RGB8I),$===i.SHORT&&(ne=i.RGB16I),$===i.INT&&(ne=i.RGB32I)),S===i.RGBA_INTEGER&&($===i.UNSIGNED_BYTE&&(ne=i.RGBA8UI),$===i.UNSIGNED_SHORT&&(ne=i.RGBA16UI),$===i.UNSIGNED_INT&&(ne=i.RGBA32UI),$===i.BYTE&&(ne=i.RGBA8I),$===i.SHORT&&(ne=i.RGBA16I),$===i.INT&&(ne=i.RGBA32I)),S===i.RGB&&($===i.UNSIGNED_SHORT&&xe&&(ne=xe.RGB16_EXT),$===i.SHORT&&xe&&(ne=xe.RGB16_SNORM_EXT),$===i.UNSIGNED_INT_5_9_9_9_REV&&(ne=i.RGB9_E5),$===i.UNSIGNED_INT_10F_11F_11F_REV&&(ne=i.R11F_G11F_B10F)),S===i.RGBA){let se=ve?Sa:vt.getTransfer(oe);$===i.FLOAT&&(ne=i.RGBA32F),$===i.HALF_FLOAT&&(ne=i.RGBA16F),$===i.UNSIGNED_BYTE&&(ne=se===Pt?i.SRGB8_ALPHA8:i.RGBA8),$===i.UNSIGNED_SHORT&&xe&&(ne=xe.RGBA16_EXT),$===i.SHORT&&xe&&(ne=xe.RGBA16_SNORM_EXT),$===i.UNSIGNED_SHORT_4_4_4_4&&(ne=i.RGBA4),$===i.UNSIGNED_SHORT_5_5_5_1&&(ne=i.RGB5_A1)}return(ne===i.R16F||ne===i.R32F||ne===i.RG16F||ne===i.RG32F||ne===i.RGBA16F||ne===i.RGBA32F)&&e.get("EXT_color_buffer_float"),ne}function x(P,S){let $;return P?S===null||S===zi||S===Nr?$=i.DEPTH24_STENCIL8:S===Vi?$=i.DEPTH32F_STENCIL8:S===Bo&&($=i.DEPTH24_STENCIL8,Ze("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===zi||S===Nr?$=i.DEPTH_COMPONENT24:S===Vi?$=i.DEPTH_COMPONENT32F:S===Bo&&($=i.DEPTH_COMPONENT16),$}function w(P,S){return M(P)===!0||P.isFramebufferTexture&&P.minFilter!==Pn&&P.minFilter!==Dn?Math.log2(Math.max(S.width,S.height))+1:P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?S.mipmaps.length:1}function F(P){let S=new WeakRef(P);n.get(P).__ref=S,g.add(S),y.register(P,S,S)}function N(P){let S=n.get(P).__ref;S!==void 0&&(g.delete(S),y.unregister(S))}function R(P){k(P.target)}function U(P){I(P.target)}function k(P){P.removeEventListener("dispose",R),N(P),Y(P),P.isVideoTexture&&h.delete(P),P.isHTMLTexture&&u.delete(P)}function I(P){P.removeEventListener("dispose",U),N(P),le(P)}function H(){for(let P of g){let S=P.deref();S!==void 0&&(S.isRenderTarget===!0?I(S):k(S))}g.clear(),u.clear()}function Y(P){let S=n.get(P);if(S.__webglInit===void 0)return;let $=P.source,de=m.get($);if(de){let oe=de[S.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&W(P),Object.keys(de).length===0&&m.delete($)}n.remove(P)}function W(P){let S=n.get(P);i.deleteTexture(S.__webglTexture);let $=P.source,de=m.get($);delete de[S.__cacheKey],o.memory.textures--}function le(P){let S=n.get(P);S.__depthDisposeCallback&&S.__depthDisposeCallback();let $=P.depthTexture;if($&&$.renderTarget===P&&k($),P.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(S.__webglFramebuffer[oe]))for(let ve=0;ve<S.__webglFramebuffer[oe].length;ve++)i.deleteFramebuffer(S.__webglFramebuffer[oe][ve]);else i.deleteFramebuffer(S.__webglFramebuffer[oe]);S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer[oe])}else{if(Array.isArray(S.__webglFramebuffer))for(let oe=0;oe<S.__webglFramebuffer.length;oe++)i.deleteFramebuffer(S.__webglFramebuffer[oe]);else i.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&i.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let oe=0;oe<S.__webglColorRenderbuffer.length;oe++)S.__webglColorRenderbuffer[oe]&&i.deleteRenderbuffer(S.__webglColorRenderbuffer[oe]);S.__webglDepthRenderbuffer&&i.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let de=P.textures;for(let oe=0,ve=de.length;oe<ve;oe++){let xe=n.get(de[oe]);xe.__webglTexture&&(i.deleteTexture(xe.__webglTexture),o.memory.textures--),n.remove(de[oe])}n.remove(P)}let Z=0;function q(){Z=0}function te(){return Z}function ce(P){Z=P}function he(){let P=Z;return P>=s.maxTextures&&Ze("WebGLTextures: Trying to use "+(P+1)+" texture units while this GPU supports only "+s.maxTextures),Z+=1,P}function Q(P){let S=[];return S.push(P.wrapS),S.push(P.wrapT),S.push(P.wrapR||0),S.push(P.magFilter),S.push(P.minFilter),S.push(P.anisotropy),S.push(P.internalFormat),S.push(P.format),S.push(P.type),S.push(P.generateMipmaps),S.push(P.mipmapsAutoUpdate),S.push(P.premultiplyAlpha),S.push(P.flipY),S.push(P.unpackAlignment),S.push(P.colorSpace),S.join()}function me(P,S){let $=n.get(P);if(P.isVideoTexture&&Ft(P),P.isRenderTargetTexture===!1&&P.isExternalTexture!==!0&&P.version>0&&$.__version!==P.version){let de=P.image;if(de===null)Ze("WebGLRenderer: Texture marked for update but no image data found.");else if(de.complete===!1)Ze("WebGLRenderer: Texture marked for update but image is incomplete");else{Bt($,P,S);return}}else P.isExternalTexture&&($.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,$.__webglTexture,i.TEXTURE0+S)}function ge(P,S){let $=n.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&$.__version!==P.version){Bt($,P,S);return}else P.isExternalTexture&&($.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,$.__webglTexture,i.TEXTURE0+S)}function Ae(P,S){let $=n.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&$.__version!==P.version){Bt($,P,S);return}t.bindTexture(i.TEXTURE_3D,$.__webglTexture,i.TEXTURE0+S)}function Me(P,S){let $=n.get(P);if(P.version>0&&$.__version!==P.version){ln($,P,S);return}t.bindTexture(i.TEXTURE_CUBE_MAP,$.__webglTexture,i.TEXTURE0+S)}let Xe={[yc]:i.REPEAT,[os]:i.CLAMP_TO_EDGE,[vc]:i.MIRRORED_REPEAT},rt={[Pn]:i.NEAREST,[ey]:i.NEAREST_MIPMAP_NEAREST,[ka]:i.NEAREST_MIPMAP_LINEAR,[Dn]:i.LINEAR,[$c]:i.LINEAR_MIPMAP_NEAREST,[Bi]:i.LINEAR_MIPMAP_LINEAR},He={[sy]:i.NEVER,[xf]:i.ALWAYS,[ry]:i.LESS,[yf]:i.LEQUAL,[oy]:i.EQUAL,[vf]:i.GEQUAL,[ay]:i.GREATER,[ly]:i.NOTEQUAL};function ut(P,S){if(S.type===Vi&&e.has("OES_texture_float_linear")===!1&&(S.magFilter===Dn||S.magFilter===$c||S.magFilter===ka||S.magFilter===Bi||S.minFilter===Dn||S.minFilter===$c||S.minFilter===ka||S.minFilter===Bi)&&Ze("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(P,i.TEXTURE_WRAP_S,Xe[S.wrapS]),i.texParameteri(P,i.TEXTURE_WRAP_T,Xe[S.wrapT]),(P===i.TEXTURE_3D||P===i.TEXTURE_2D_ARRAY)&&i.texParameteri(P,i.TEXTURE_WRAP_R,Xe[S.wrapR]),i.texParameteri(P,i.TEXTURE_MAG_FILTER,rt[S.magFilter]),i.texParameteri(P,i.TEXTURE_MIN_FILTER,rt[S.minFilter]),S.compareFunction&&(i.texParameteri(P,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(P,i.TEXTURE_COMPARE_FUNC,He[S.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===Pn||S.minFilter!==ka&&S.minFilter!==Bi||S.type===Vi&&e.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||n.get(S).__currentAnisotropy){let $=e.get("EXT_texture_filter_anisotropic");i.texParameterf(P,$.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),n.get(S).__currentAnisotropy=S.anisotropy}}}function lt(P,S){let $=!1;P.__webglInit===void 0&&(P.__webglInit=!0,S.addEventListener("dispose",R),F(S));let de=S.source,oe=m.get(de);oe===void 0&&(oe={},m.set(de,oe));let ve=Q(S);if(ve!==P.__cacheKey){oe[ve]===void 0&&(oe[ve]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,$=!0),oe[ve].usedTimes++;let xe=oe[P.__cacheKey];xe!==void 0&&(oe[P.__cacheKey].usedTimes--,xe.usedTimes===0&&W(S)),P.__cacheKey=ve,P.__webglTexture=oe[ve].texture}return $}function it(P,S,$){return Math.floor(Math.floor(P/$)/S)}function $t(P,S,$,de){let ve=P.updateRanges;if(ve.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,S.width,S.height,$,de,S.data);else{ve.sort((B,re)=>B.start-re.start);let xe=0;for(let B=1;B<ve.length;B++){let re=ve[xe],ie=ve[B],we=re.start+re.count,ye=it(ie.start,S.width,4),be=it(re.start,S.width,4);ie.start<=we+1&&ye===be&&it(ie.start+ie.count-1,S.width,4)===ye?re.count=Math.max(re.count,ie.start+ie.count-re.start):(++xe,ve[xe]=ie)}ve.length=xe+1;let ne=t.getParameter(i.UNPACK_ROW_LENGTH),se=t.getParameter(i.UNPACK_SKIP_PIXELS),pe=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,S.width);for(let B=0,re=ve.length;B<re;B++){let ie=ve[B],we=Math.floor(ie.start/4),ye=Math.ceil(ie.count/4),be=we%S.width,We=Math.floor(we/S.width),je=ye,ue=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,be),t.pixelStorei(i.UNPACK_SKIP_ROWS,We),t.texSubImage2D(i.TEXTURE_2D,0,be,We,je,ue,$,de,S.data)}P.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,ne),t.pixelStorei(i.UNPACK_SKIP_PIXELS,se),t.pixelStorei(i.UNPACK_SKIP_ROWS,pe)}}function Bt(P,S,$){let de=i.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(de=i.TEXTURE_2D_ARRAY),S.isData3DTexture&&(de=i.TEXTURE_3D);let oe=lt(P,S),ve=S.source;t.bindTexture(de,P.__webglTexture,i.TEXTURE0+$);let xe=n.get(ve);if(ve.version!==xe.__version||oe===!0){if(t.activeTexture(i.TEXTURE0+$),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let ue=vt.getPrimaries(vt.workingColorSpace),ke=S.colorSpace===Ls?null:vt.getPrimaries(S.colorSpace),Qe=S.colorSpace===Ls||ue===ke?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Qe)}t.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment);let se=v(S.image,!1,s.maxTextureSize);se=Ve(S,se);let pe=r.convert(S.format,S.colorSpace),B=r.convert(S.type),re=T(S.internalFormat,pe,B,S.normalized,S.colorSpace,S.isVideoTexture);ut(de,S);let ie,we=S.mipmaps,ye=S.isVideoTexture!==!0,be=xe.__version===void 0||oe===!0,We=ve.dataReady,je=w(S,se);if(S.isDepthTexture)re=x(S.format===Is,S.type),be&&(ye?t.texStorage2D(i.TEXTURE_2D,1,re,se.width,se.height):t.texImage2D(i.TEXTURE_2D,0,re,se.width,se.height,0,pe,B,null));else if(S.isDataTexture)if(we.length>0){ye&&be&&t.texStorage2D(i.TEXTURE_2D,je,re,we[0].width,we[0].height);for(let ue=0,ke=we.length;ue<ke;ue++)ie=we[ue],ye?We&&t.texSubImage2D(i.TEXTURE_2D,ue,0,0,ie.width,ie.height,pe,B,ie.data):t.texImage2D(i.TEXTURE_2D,ue,re,ie.width,ie.height,0,pe,B,ie.data);S.generateMipmaps=!1}else ye?(be&&t.texStorage2D(i.TEXTURE_2D,je,re,se.width,se.height),We&&$t(S,se,pe,B)):t.texImage2D(i.TEXTURE_2D,0,re,se.width,se.height,0,pe,B,se.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){ye&&be&&t.texStorage3D(i.TEXTURE_2D_ARRAY,je,re,we[0].width,we[0].height,se.depth);for(let ue=0,ke=we.length;ue<ke;ue++)if(ie=we[ue],S.format!==Hi)if(pe!==null)if(ye){if(We)if(S.layerUpdates.size>0){let Qe=Tf(ie.width,ie.height,S.format,S.type);for(let Ce of S.layerUpdates){let at=ie.data.subarray(Ce*Qe/ie.data.BYTES_PER_ELEMENT,(Ce+1)*Qe/ie.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ue,0,0,Ce,ie.width,ie.height,1,pe,at)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ue,0,0,0,ie.width,ie.height,se.depth,pe,ie.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ue,re,ie.width,ie.height,se.depth,0,ie.data,0,0);else Ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ye?We&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,ue,0,0,0,ie.width,ie.height,se.depth,pe,B,ie.data):t.texImage3D(i.TEXTURE_2D_ARRAY,ue,re,ie.width,ie.height,se.depth,0,pe,B,ie.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{ye&&be&&t.texStorage2D(i.TEXTURE_2D,je,re,we[0].width,we[0].height);for(let ue=0,ke=we.length;ue<ke;ue++)ie=we[ue],S.format!==Hi?pe!==null?ye?We&&t.compressedTexSubImage2D(i.TEXTURE_2D,ue,0,0,ie.width,ie.height,pe,ie.data):t.compressedTexImage2D(i.TEXTURE_2D,ue,re,ie.width,ie.height,0,ie.data):Ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ye?We&&t.texSubImage2D(i.TEXTURE_2D,ue,0,0,ie.width,ie.height,pe,B,ie.data):t.texImage2D(i.TEXTURE_2D,ue,re,ie.width,ie.height,0,pe,B,ie.data)}else if(S.isDataArrayTexture)if(ye){if(be&&t.texStorage3D(i.TEXTURE_2D_ARRAY,je,re,se.width,se.height,se.depth),We)if(S.layerUpdates.size>0){let ue=Tf(se.width,se.height,S.format,S.type);for(let ke of S.layerUpdates){let Qe=se.data.subarray(ke*ue/se.data.BYTES_PER_ELEMENT,(ke+1)*ue/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,ke,se.width,se.height,1,pe,B,Qe)}S.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,pe,B,se.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,re,se.width,se.height,se.depth,0,pe,B,se.data);else if(S.isData3DTexture)ye?(be&&t.texStorage3D(i.TEXTURE_3D,je,re,se.width,se.height,se.depth),We&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,pe,B,se.data)):t.texImage3D(i.TEXTURE_3D,0,re,se.width,se.height,se.depth,0,pe,B,se.data);else if(S.isFramebufferTexture){if(be)if(ye)t.texStorage2D(i.TEXTURE_2D,je,re,se.width,se.height);else{let ue=se.width,ke=se.height;for(let Qe=0;Qe<je;Qe++)t.texImage2D(i.TEXTURE_2D,Qe,re,ue,ke,0,pe,B,null),ue>>=1,ke>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in i){let ue=i.canvas;if(ue.hasAttribute("layoutsubtree")||ue.setAttribute("layoutsubtree","true"),se.parentNode!==ue){ue.appendChild(se),u.add(S),ue.onpaint=ke=>{let Qe=ke.changedElements;for(let Ce of u)Qe.includes(Ce.image)&&(Ce.needsUpdate=!0)},ue.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,se);else{let Qe=i.RGBA,Ce=i.RGBA,at=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Qe,Ce,at,se)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(we.length>0){if(ye&&be){let ue=Ye(we[0]);t.texStorage2D(i.TEXTURE_2D,je,re,ue.width,ue.height)}for(let ue=0,ke=we.length;ue<ke;ue++)ie=we[ue],ye?We&&t.texSubImage2D(i.TEXTURE_2D,ue,0,0,pe,B,ie):t.texImage2D(i.TEXTURE_2D,ue,re,pe,B,ie);S.generateMipmaps=!1}else if(ye){if(be){let ue=Ye(se);t.texStorage2D(i.TEXTURE_2D,je,re,ue.width,ue.height)}We&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,pe,B,se)}else t.texImage2D(i.TEXTURE_2D,0,re,pe,B,se);M(S)&&S.mipmapsAutoUpdate===!0&&b(de),xe.__version=ve.version,S.onUpdate&&S.onUpdate(S)}P.__version=S.version}function ln(P,S,$){if(S.image.length!==6)return;let de=lt(P,S),oe=S.source;t.bindTexture(i.TEXTURE_CUBE_MAP,P.__webglTexture,i.TEXTURE0+$);let ve=n.get(oe);if(oe.version!==ve.__version||de===!0){t.activeTexture(i.TEXTURE0+$);let xe=vt.getPrimaries(vt.workingColorSpace),ne=S.colorSpace===Ls?null:vt.getPrimaries(S.colorSpace),se=S.colorSpace===Ls||xe===ne?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,se);let pe=S.isCompressedTexture||S.image[0].isCompressedTexture,B=S.image[0]&&S.image[0].isDataTexture,re=[];for(let Ce=0;Ce<6;Ce++)!pe&&!B?re[Ce]=v(S.image[Ce],!0,s.maxCubemapSize):re[Ce]=B?S.image[Ce].image:S.image[Ce],re[Ce]=Ve(S,re[Ce]);let ie=re[0],we=r.convert(S.format,S.colorSpace),ye=r.convert(S.type),be=T(S.internalFormat,we,ye,S.normalized,S.colorSpace),We=S.isVideoTexture!==!0,je=ve.__version===void 0||de===!0,ue=oe.dataReady,ke=w(S,ie);ut(i.TEXTURE_CUBE_MAP,S);let Qe;if(S.isDepthTexture){if(be=x(S.format===Is,S.type),je)if(We)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,be,ie.width,ie.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,be,ie.width,ie.height,0,we,ye,null)}else if(pe){We&&je&&t.texStorage2D(i.TEXTURE_CUBE_MAP,ke,be,ie.width,ie.height);for(let Ce=0;Ce<6;Ce++){Qe=re[Ce].mipmaps;for(let at=0;at<Qe.length;at++){let Vt=Qe[at];S.format!==Hi?we!==null?We?ue&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at,0,0,Vt.width,Vt.height,we,Vt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at,be,Vt.width,Vt.height,0,Vt.data):Ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):We?ue&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at,0,0,Vt.width,Vt.height,we,ye,Vt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at,be,Vt.width,Vt.height,0,we,ye,Vt.data)}}}else{if(Qe=S.mipmaps,We&&je){Qe.length>0&&ke++;let Ce=Ye(re[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,ke,be,Ce.width,Ce.height)}for(let Ce=0;Ce<6;Ce++)if(B){We?ue&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,re[Ce].width,re[Ce].height,we,ye,re[Ce].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,be,re[Ce].width,re[Ce].height,0,we,ye,re[Ce].data);for(let at=0;at<Qe.length;at++){let Wn=Qe[at].image[Ce].image;We?ue&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at+1,0,0,Wn.width,Wn.height,we,ye,Wn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at+1,be,Wn.width,Wn.height,0,we,ye,Wn.data)}}else{We?ue&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,we,ye,re[Ce]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,be,we,ye,re[Ce]);for(let at=0;at<Qe.length;at++){let Vt=Qe[at];We?ue&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at+1,0,0,we,ye,Vt.image[Ce]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,at+1,be,we,ye,Vt.image[Ce])}}}M(S)&&S.mipmapsAutoUpdate===!0&&b(i.TEXTURE_CUBE_MAP),ve.__version=oe.version,S.onUpdate&&S.onUpdate(S)}P.__version=S.version}function Dt(P,S,$,de,oe,ve){let xe=r.convert($.format,$.colorSpace),ne=r.convert($.type),se=T($.internalFormat,xe,ne,$.normalized,$.colorSpace),pe=n.get(S),B=n.get($);if(B.__renderTarget=S,!pe.__hasExternalTextures){let re=Math.max(1,S.width>>ve),ie=Math.max(1,S.height>>ve);oe===i.TEXTURE_3D||oe===i.TEXTURE_2D_ARRAY?t.texImage3D(oe,ve,se,re,ie,S.depth,0,xe,ne,null):t.texImage2D(oe,ve,se,re,ie,0,xe,ne,null)}t.bindFramebuffer(i.FRAMEBUFFER,P),Se(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,de,oe,B.__webglTexture,0,ot(S)):(oe===i.TEXTURE_2D||oe>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,de,oe,B.__webglTexture,ve),t.bindFramebuffer(i.FRAMEBUFFER,null)}function wn(P,S,$){if(i.bindRenderbuffer(i.RENDERBUFFER,P),S.depthBuffer){let de=S.depthTexture,oe=de&&de.isDepthTexture?de.type:null,ve=x(S.stencilBuffer,oe),xe=S.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Se(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ot(S),ve,S.width,S.height):$?i.renderbufferStorageMultisample(i.RENDERBUFFER,ot(S),ve,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,ve,S.width,S.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,xe,i.RENDERBUFFER,P)}else{let de=S.textures;for(let oe=0;oe<de.length;oe++){let ve=de[oe],xe=r.convert(ve.format,ve.colorSpace),ne=r.convert(ve.type),se=T(ve.internalFormat,xe,ne,ve.normalized,ve.colorSpace);Se(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ot(S),se,S.width,S.height):$?i.renderbufferStorageMultisample(i.RENDERBUFFER,ot(S),se,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,se,S.width,S.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Mt(P,S,$){let de=S.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,P),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=n.get(S.depthTexture);oe.__renderTarget=S;let ve=de?S.depthTexture.image[0]:S.depthTexture.image;(!oe.__webglTexture||ve.width!==S.width||ve.height!==S.height)&&(ve.width=S.width,ve.height=S.height,S.depthTexture.needsUpdate=!0),de?Me(S.depthTexture,0):me(S.depthTexture,0);let xe=oe.__webglTexture,ne=ot(S),se=de?i.TEXTURE_CUBE_MAP_POSITIVE_X+$:i.TEXTURE_2D,pe=S.depthTexture.format===Is?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(S.depthTexture.format===Ts)Se(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,pe,se,xe,0,ne):i.framebufferTexture2D(i.FRAMEBUFFER,pe,se,xe,0);else if(S.depthTexture.format===Is)Se(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,pe,se,xe,0,ne):i.framebufferTexture2D(i.FRAMEBUFFER,pe,se,xe,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function gn(P){let S=n.get(P),$=P.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==P.depthTexture){let de=P.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),de){let oe=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,de.removeEventListener("dispose",oe)};de.addEventListener("dispose",oe),S.__depthDisposeCallback=oe}S.__boundDepthTexture=de}if(P.depthTexture&&!S.__autoAllocateDepthBuffer)if($)for(let de=0;de<6;de++)Mt(S.__webglFramebuffer[de],P,de);else P.texture.mipmaps.length>0?Mt(S.__webglFramebuffer[0],P,0):Mt(S.__webglFramebuffer,P,0);else if($){S.__webglDepthbuffer=[];for(let de=0;de<6;de++)if(t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[de]),S.__webglDepthbuffer[de]===void 0)S.__webglDepthbuffer[de]=i.createRenderbuffer(),wn(S.__webglDepthbuffer[de],P,!1);else{let oe=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ve=S.__webglDepthbuffer[de];i.bindRenderbuffer(i.RENDERBUFFER,ve),i.framebufferRenderbuffer(i.FRAMEBUFFER,oe,i.RENDERBUFFER,ve)}}else if(P.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=i.createRenderbuffer(),wn(S.__webglDepthbuffer,P,!1);else{let oe=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ve=S.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,ve),i.framebufferRenderbuffer(i.FRAMEBUFFER,oe,i.RENDERBUFFER,ve)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function en(P,S,$){let de=n.get(P);S!==void 0&&Dt(de.__webglFramebuffer,P,P.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),$!==void 0&&gn(P)}function cn(P){let S=P.texture,$=n.get(P),de=n.get(S);P.addEventListener("dispose",U),F(P);let oe=P.textures,ve=P.isWebGLCubeRenderTarget===!0,xe=oe.length>1;if(xe||(de.__webglTexture===void 0&&(de.__webglTexture=i.createTexture()),de.__version=S.version,o.memory.textures++),ve){$.__webglFramebuffer=[];for(let ne=0;ne<6;ne++)if(S.mipmaps.length>0){$.__webglFramebuffer[ne]=[];for(let se=0;se<S.mipmaps.length;se++)$.__webglFramebuffer[ne][se]=i.createFramebuffer()}else $.__webglFramebuffer[ne]=i.createFramebuffer()}else{if(S.mipmaps.length>0){$.__webglFramebuffer=[];for(let ne=0;ne<S.mipmaps.length;ne++)$.__webglFramebuffer[ne]=i.createFramebuffer()}else $.__webglFramebuffer=i.createFramebuffer();if(xe)for(let ne=0,se=oe.length;ne<se;ne++){let pe=n.get(oe[ne]);pe.__webglTexture===void 0&&(pe.__webglTexture=i.createTexture(),o.memory.textures++)}if(P.samples>0&&Se(P)===!1){$.__webglMultisampledFramebuffer=i.createFramebuffer(),$.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,$.__webglMultisampledFramebuffer);for(let ne=0;ne<oe.length;ne++){let se=oe[ne];$.__webglColorRenderbuffer[ne]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,$.__webglColorRenderbuffer[ne]);let pe=r.convert(se.format,se.colorSpace),B=r.convert(se.type),re=T(se.internalFormat,pe,B,se.normalized,se.colorSpace,P.isXRRenderTarget===!0),ie=ot(P);i.renderbufferStorageMultisample(i.RENDERBUFFER,ie,re,P.width,P.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ne,i.RENDERBUFFER,$.__webglColorRenderbuffer[ne])}i.bindRenderbuffer(i.RENDERBUFFER,null),P.depthBuffer&&($.__webglDepthRenderbuffer=i.createRenderbuffer(),wn($.__webglDepthRenderbuffer,P,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(ve){t.bindTexture(i.TEXTURE_CUBE_MAP,de.__webglTexture),ut(i.TEXTURE_CUBE_MAP,S);for(let ne=0;ne<6;ne++)if(S.mipmaps.length>0)for(let se=0;se<S.mipmaps.length;se++)Dt($.__webglFramebuffer[ne][se],P,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ne,se);else Dt($.__webglFramebuffer[ne],P,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ne,0);M(S)?b(i.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}else if(xe){for(let ne=0,se=oe.length;ne<se;ne++){let pe=oe[ne],B=n.get(pe),re=i.TEXTURE_2D;(P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(re=P.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(re,B.__webglTexture),ut(re,pe),Dt($.__webglFramebuffer,P,pe,i.COLOR_ATTACHMENT0+ne,re,0),M(pe)&&b(re)}t.unbindTexture()}else{let ne=i.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(ne=P.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ne,de.__webglTexture),ut(ne,S),S.mipmaps.length>0)for(let se=0;se<S.mipmaps.length;se++)Dt($.__webglFramebuffer[se],P,S,i.COLOR_ATTACHMENT0,ne,se);else Dt($.__webglFramebuffer,P,S,i.COLOR_ATTACHMENT0,ne,0);M(S)?b(ne):S.mipmaps.length>0&&i.texParameteri(ne,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}P.depthBuffer&&gn(P)}function z(P){let S=P.textures;for(let $=0,de=S.length;$<de;$++){let oe=S[$];if(M(oe)&&oe.mipmapsAutoUpdate===!0){let ve=E(P),xe=n.get(oe).__webglTexture;t.bindTexture(ve,xe),b(ve),t.unbindTexture()}}}let Re=[];function Je(P){if(P.samples>0){if(Se(P)===!1){let S=P.textures,$=P.width,de=P.height,oe=i.COLOR_BUFFER_BIT,ve=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,xe=n.get(P),ne=S.length>1;if(ne)for(let pe=0;pe<S.length;pe++)t.bindFramebuffer(i.FRAMEBUFFER,xe.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,xe.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,xe.__webglMultisampledFramebuffer),P.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,xe.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,xe.__webglFramebuffer);for(let pe=0;pe<S.length;pe++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(oe|=i.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(oe|=i.STENCIL_BUFFER_BIT)),ne){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,xe.__webglColorRenderbuffer[pe]);let B=n.get(S[pe]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,B,0)}i.blitFramebuffer(0,0,$,de,0,0,$,de,oe,i.NEAREST),l===!0&&(Re.length=0,Re.push(i.COLOR_ATTACHMENT0+pe),P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&Re.push(ve),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Re))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),ne)for(let pe=0;pe<S.length;pe++){t.bindFramebuffer(i.FRAMEBUFFER,xe.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.RENDERBUFFER,xe.__webglColorRenderbuffer[pe]);let B=n.get(S[pe]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,xe.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.TEXTURE_2D,B,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,xe.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&l){let S=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[S])}}}function ot(P){return Math.min(s.maxSamples,P.samples)}function Se(P){let S=n.get(P);return P.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function Ft(P){let S=o.render.frame;h.get(P)!==S&&(h.set(P,S),P.update())}function Ve(P,S){let $=P.colorSpace,de=P.format,oe=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||$!==Ma&&$!==Ls&&(vt.getTransfer($)===Pt?(de!==Hi||oe!==yi)&&Ze("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):tt("WebGLTextures: Unsupported texture color space:",$)),S}function Ye(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=he,this.resetTextureUnits=q,this.getTextureUnits=te,this.setTextureUnits=ce,this.setTexture2D=me,this.setTexture2DArray=ge,this.setTexture3D=Ae,this.setTextureCube=Me,this.rebindTextures=en,this.setupRenderTarget=cn,this.updateRenderTargetMipmap=z,this.updateMultisampleRenderTarget=Je,this.setupDepthRenderbuffer=gn,this.setupFrameBufferTexture=Dt,this.useMultisampledRTT=Se,this.dispose=H}function gT(i,e){function t(n,s=Ls){let r,o=vt.getTransfer(s);if(n===yi)return i.UNSIGNED_BYTE;if(n===Jc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Zc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===uf)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===df)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===cf)return i.BYTE;if(n===hf)return i.SHORT;if(n===Bo)return i.UNSIGNED_SHORT;if(n===Yc)return i.INT;if(n===zi)return i.UNSIGNED_INT;if(n===Vi)return i.FLOAT;if(n===Gi)return i.HALF_FLOAT;if(n===ff)return i.ALPHA;if(n===pf)return i.RGB;if(n===Hi)return i.RGBA;if(n===Ts)return i.DEPTH_COMPONENT;if(n===Is)return i.DEPTH_STENCIL;if(n===mf)return i.RED;if(n===Kc)return i.RED_INTEGER;if(n===ur)return i.RG;if(n===jc)return i.RG_INTEGER;if(n===Qc)return i.RGBA_INTEGER;if(n===Ba||n===za||n===Va||n===Ga)if(o===Pt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Ba)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===za)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Va)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Ga)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Ba)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===za)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Va)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Ga)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===eh||n===th||n===nh||n===ih)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===eh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===th)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===nh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===ih)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===sh||n===rh||n===oh||n===ah||n===lh||n===Ha||n===ch)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===sh||n===rh)return o===Pt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===oh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===ah)return r.COMPRESSED_R11_EAC;if(n===lh)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Ha)return r.COMPRESSED_RG11_EAC;if(n===ch)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===hh||n===uh||n===dh||n===fh||n===ph||n===mh||n===gh||n===yh||n===vh||n===xh||n===_h||n===bh||n===Mh||n===Sh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===hh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===uh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===dh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===fh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===ph)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===mh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===gh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===yh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===vh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===xh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===_h)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===bh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Mh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Sh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===wh||n===Eh||n===Th)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===wh)return o===Pt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Eh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Th)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Ah||n===Ch||n===Wa||n===Rh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===Ah)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Ch)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Wa)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Rh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Nr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var yT=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,vT=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Uf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new La(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new Un({vertexShader:yT,fragmentShader:vT,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Kt(new Rs(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Ff=class extends as{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,m=null,g=null,y=typeof XRWebGLBinding<"u",p=new Uf,f={},v=t.getContextAttributes(),M=null,b=null,E=[],T=[],x=new _t,w=null,F=null,N=new jn;N.viewport=new Qt;let R=new jn;R.viewport=new Qt;let U=[N,R],k=new Wc,I=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let me=E[Q];return me===void 0&&(me=new Ro,E[Q]=me),me.getTargetRaySpace()},this.getControllerGrip=function(Q){let me=E[Q];return me===void 0&&(me=new Ro,E[Q]=me),me.getGripSpace()},this.getHand=function(Q){let me=E[Q];return me===void 0&&(me=new Ro,E[Q]=me),me.getHandSpace()};function Y(Q){let me=T.indexOf(Q.inputSource);if(me===-1)return;let ge=E[me];ge!==void 0&&(ge.update(Q.inputSource,Q.frame,c||o),ge.dispatchEvent({type:Q.type,data:Q.inputSource}))}function W(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",W),s.removeEventListener("inputsourceschange",le);for(let Q=0;Q<E.length;Q++){let me=T[Q];me!==null&&(T[Q]=null,E[Q].disconnect(me))}I=null,H=null,p.reset();for(let Q in f)delete f[Q];if(e.setRenderTarget(M),m=null,d=null,u=null,s=null,b=null,he.stop(),n.isPresenting=!1,e.setPixelRatio(w),e.setSize(x.width,x.height,!1),F!==null){let Q=F.camera;Q.fov=F.fov,Q.zoom=F.zoom,Q.updateProjectionMatrix(),F=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,n.isPresenting===!0&&Ze("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,n.isPresenting===!0&&Ze("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return d!==null?d:m},this.getBinding=function(){return u===null&&y&&(u=new XRWebGLBinding(s,t)),u},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(M=e.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",W),s.addEventListener("inputsourceschange",le),v.xrCompatible!==!0&&await t.makeXRCompatible(),w=e.getPixelRatio(),e.getSize(x),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let ge=null,Ae=null,Me=null;v.depth&&(Me=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ge=v.stencil?Is:Ts,Ae=v.stencil?Nr:zi);let Xe={colorFormat:t.RGBA8,depthFormat:Me,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Xe),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),b=new ei(d.textureWidth,d.textureHeight,{format:Hi,type:yi,depthTexture:new Cs(d.textureWidth,d.textureHeight,Ae,void 0,void 0,void 0,void 0,void 0,void 0,ge),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let ge={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};m=new XRWebGLLayer(s,t,ge),s.updateRenderState({baseLayer:m}),e.setPixelRatio(1),e.setSize(m.framebufferWidth,m.framebufferHeight,!1),b=new ei(m.framebufferWidth,m.framebufferHeight,{format:Hi,type:yi,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:m.ignoreDepthValues===!1,resolveStencilBuffer:m.ignoreDepthValues===!1,storeMultisampledDepthBuffer:m.ignoreDepthValues===!1,storeMultisampledStencilBuffer:m.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),he.setContext(s),he.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function le(Q){for(let me=0;me<Q.removed.length;me++){let ge=Q.removed[me],Ae=T.indexOf(ge);Ae>=0&&(T[Ae]=null,E[Ae].disconnect(ge))}for(let me=0;me<Q.added.length;me++){let ge=Q.added[me],Ae=T.indexOf(ge);if(Ae===-1){for(let Xe=0;Xe<E.length;Xe++)if(Xe>=T.length){T.push(ge),Ae=Xe;break}else if(T[Xe]===null){T[Xe]=ge,Ae=Xe;break}if(Ae===-1)break}let Me=E[Ae];Me&&Me.connect(ge)}}function Z(Q,me){me===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(me.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let me=Q.near,ge=Q.far;p.texture!==null&&(p.depthNear>0&&(me=p.depthNear),p.depthFar>0&&(ge=p.depthFar)),k.near=R.near=N.near=me,k.far=R.far=N.far=ge,(I!==k.near||H!==k.far)&&(s.updateRenderState({depthNear:k.near,depthFar:k.far}),I=k.near,H=k.far),k.layers.mask=Q.layers.mask|6,N.layers.mask=k.layers.mask&-5,R.layers.mask=k.layers.mask&-3;let Ae=Q.parent,Me=k.cameras;Z(k,Ae);for(let Xe=0;Xe<Me.length;Xe++)Z(Me[Xe],Ae);k.projectionMatrix.copy(N.projectionMatrix),k.projectionMatrixInverse.copy(N.projectionMatrixInverse),F===null&&Q.isPerspectiveCamera&&(F={camera:Q,fov:Q.fov,zoom:Q.zoom}),q(Q,k,Ae)};function q(Q,me,ge){ge===null?Q.matrix.copy(me.matrixWorld):(Q.matrix.copy(ge.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(me.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(me.projectionMatrix),Q.projectionMatrixInverse.copy(me.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=_c*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return k},this.getFoveation=function(){if(!(d===null&&m===null))return l},this.setFoveation=function(Q){l=Q,d!==null&&(d.fixedFoveation=Q),m!==null&&m.fixedFoveation!==void 0&&(m.fixedFoveation=Q)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(k)},this.getCameraTexture=function(Q){return f[Q]};let te=null;function ce(Q,me){if(h=me.getViewerPose(c||o),g=me,h!==null){let ge=h.views;m!==null&&(e.setRenderTargetFramebuffer(b,m.framebuffer),e.setRenderTarget(b));let Ae=!1;ge.length!==k.cameras.length&&(k.cameras.length=0,Ae=!0);for(let He=0;He<ge.length;He++){let ut=ge[He],lt=null;if(m!==null)lt=m.getViewport(ut);else{let $t=u.getViewSubImage(d,ut);lt=$t.viewport,He===0&&(e.setRenderTargetTextures(b,$t.colorTexture,$t.depthStencilTexture),e.setRenderTarget(b))}let it=U[He];it===void 0&&(it=new jn,it.layers.enable(He),it.viewport=new Qt,U[He]=it),it.matrix.fromArray(ut.transform.matrix),it.matrix.decompose(it.position,it.quaternion,it.scale),it.projectionMatrix.fromArray(ut.projectionMatrix),it.projectionMatrixInverse.copy(it.projectionMatrix).invert(),it.viewport.set(lt.x,lt.y,lt.width,lt.height),He===0&&(k.matrix.copy(it.matrix),k.matrix.decompose(k.position,k.quaternion,k.scale)),Ae===!0&&k.cameras.push(it)}let Me=s.enabledFeatures;if(Me&&Me.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){u=n.getBinding();let He=u.getDepthInformation(ge[0]);He&&He.isValid&&He.texture&&p.init(He,s.renderState)}if(Me&&Me.includes("camera-access")&&y){e.state.unbindTexture(),u=n.getBinding();for(let He=0;He<ge.length;He++){let ut=ge[He].camera;if(ut){let lt=f[ut];lt||(lt=new La,f[ut]=lt);let it=u.getCameraImage(ut);lt.sourceTexture=it}}}}for(let ge=0;ge<E.length;ge++){let Ae=T[ge],Me=E[ge];Ae!==null&&Me!==void 0&&Me.update(Ae,me,c||o)}te&&te(Q,me),me.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:me}),g=null}let he=new zy;he.setAnimationLoop(ce),this.setAnimationLoop=function(Q){te=Q},this.dispose=function(){}}},xT=new zt,Zy=new nt;Zy.set(-1,0,0,0,1,0,0,0,1);function _T(i,e){function t(p,f){p.matrixAutoUpdate===!0&&p.updateMatrix(),f.value.copy(p.matrix)}function n(p,f){f.color.getRGB(p.fogColor.value,Sf(i)),f.isFog?(p.fogNear.value=f.near,p.fogFar.value=f.far):f.isFogExp2&&(p.fogDensity.value=f.density)}function s(p,f,v,M,b){f.isNodeMaterial?f.uniformsNeedUpdate=!1:f.isMeshBasicMaterial?r(p,f):f.isMeshLambertMaterial?(r(p,f),f.envMap&&(p.envMapIntensity.value=f.envMapIntensity)):f.isMeshToonMaterial?(r(p,f),u(p,f)):f.isMeshPhongMaterial?(r(p,f),h(p,f),f.envMap&&(p.envMapIntensity.value=f.envMapIntensity)):f.isMeshStandardMaterial?(r(p,f),d(p,f),f.isMeshPhysicalMaterial&&m(p,f,b)):f.isMeshMatcapMaterial?(r(p,f),g(p,f)):f.isMeshDepthMaterial?r(p,f):f.isMeshDistanceMaterial?(r(p,f),y(p,f)):f.isMeshNormalMaterial?r(p,f):f.isLineBasicMaterial?(o(p,f),f.isLineDashedMaterial&&a(p,f)):f.isPointsMaterial?l(p,f,v,M):f.isSpriteMaterial?c(p,f):f.isShadowMaterial?(p.color.value.copy(f.color),p.opacity.value=f.opacity):f.isShaderMaterial&&(f.uniformsNeedUpdate=!1)}function r(p,f){p.opacity.value=f.opacity,f.color&&p.diffuse.value.copy(f.color),f.emissive&&p.emissive.value.copy(f.emissive).multiplyScalar(f.emissiveIntensity),f.map&&(p.map.value=f.map,t(f.map,p.mapTransform)),f.alphaMap&&(p.alphaMap.value=f.alphaMap,t(f.alphaMap,p.alphaMapTransform)),f.bumpMap&&(p.bumpMap.value=f.bumpMap,t(f.bumpMap,p.bumpMapTransform),p.bumpScale.value=f.bumpScale,f.side===ti&&(p.bumpScale.value*=-1)),f.normalMap&&(p.normalMap.value=f.normalMap,t(f.normalMap,p.normalMapTransform),p.normalScale.value.copy(f.normalScale),f.side===ti&&p.normalScale.value.negate()),f.displacementMap&&(p.displacementMap.value=f.displacementMap,t(f.displacementMap,p.displacementMapTransform),p.displacementScale.value=f.displacementScale,p.displacementBias.value=f.displacementBias),f.emissiveMap&&(p.emissiveMap.value=f.emissiveMap,t(f.emissiveMap,p.emissiveMapTransform)),f.specularMap&&(p.specularMap.value=f.specularMap,t(f.specularMap,p.specularMapTransform)),f.alphaTest>0&&(p.alphaTest.value=f.alphaTest);let v=e.get(f),M=v.envMap,b=v.envMapRotation;M&&(p.envMap.value=M,p.envMapRotation.value.setFromMatrix4(xT.makeRotationFromEuler(b)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(Zy),p.reflectivity.value=f.reflectivity,p.ior.value=f.ior,p.refractionRatio.value=f.refractionRatio),f.lightMap&&(p.lightMap.value=f.lightMap,p.lightMapIntensity.value=f.lightMapIntensity,t(f.lightMap,p.lightMapTransform)),f.aoMap&&(p.aoMap.value=f.aoMap,p.aoMapIntensity.value=f.aoMapIntensity,t(f.aoMap,p.aoMapTransform))}function o(p,f){p.diffuse.value.copy(f.color),p.opacity.value=f.opacity,f.map&&(p.map.value=f.map,t(f.map,p.mapTransform))}function a(p,f){p.dashSize.value=f.dashSize,p.totalSize.value=f.dashSize+f.gapSize,p.scale.value=f.scale}function l(p,f,v,M){p.diffuse.value.copy(f.color),p.opacity.value=f.opacity,p.size.value=f.size*v,p.scale.value=M*.5,f.map&&(p.map.value=f.map,t(f.map,p.uvTransform)),f.alphaMap&&(p.alphaMap.value=f.alphaMap,t(f.alphaMap,p.alphaMapTransform)),f.alphaTest>0&&(p.alphaTest.value=f.alphaTest)}function c(p,f){p.diffuse.value.copy(f.color),p.opacity.value=f.opacity,p.rotation.value=f.rotation,f.map&&(p.map.value=f.map,t(f.map,p.mapTransform)),f.alphaMap&&(p.alphaMap.value=f.alphaMap,t(f.alphaMap,p.alphaMapTransform)),f.alphaTest>0&&(p.alphaTest.value=f.alphaTest)}function h(p,f){p.specular.value.copy(f.specular),p.shininess.value=Math.max(f.shininess,1e-4)}function u(p,f){f.gradientMap&&(p.gradientMap.value=f.gradientMap)}function d(p,f){p.metalness.value=f.metalness,f.metalnessMap&&(p.metalnessMap.value=f.metalnessMap,t(f.metalnessMap,p.metalnessMapTransform)),p.roughness.value=f.roughness,f.roughnessMap&&(p.roughnessMap.value=f.roughnessMap,t(f.roughnessMap,p.roughnessMapTransform)),f.envMap&&(p.envMapIntensity.value=f.envMapIntensity)}function m(p,f,v){p.ior.value=f.ior,f.diffuseRoughness>0&&(p.diffuseRoughness.value=f.diffuseRoughness,f.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=f.diffuseRoughnessMap,t(f.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),f.sheen>0&&(p.sheenColor.value.copy(f.sheenColor).multiplyScalar(f.sheen),p.sheenRoughness.value=f.sheenRoughness,f.sheenColorMap&&(p.sheenColorMap.value=f.sheenColorMap,t(f.sheenColorMap,p.sheenColorMapTransform)),f.sheenRoughnessMap&&(p.sheenRoughnessMap.value=f.sheenRoughnessMap,t(f.sheenRoughnessMap,p.sheenRoughnessMapTransform))),f.clearcoat>0&&(p.clearcoat.value=f.clearcoat,p.clearcoatRoughness.value=f.clearcoatRoughness,f.clearcoatMap&&(p.clearcoatMap.value=f.clearcoatMap,t(f.clearcoatMap,p.clearcoatMapTransform)),f.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=f.clearcoatRoughnessMap,t(f.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),f.clearcoatNormalMap&&(p.clearcoatNormalMap.value=f.clearcoatNormalMap,t(f.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(f.clearcoatNormalScale),f.side===ti&&p.clearcoatNormalScale.value.negate())),f.dispersion>0&&(p.dispersion.value=f.dispersion),f.retroreflectivity>0&&(p.retroreflectivity.value=f.retroreflectivity),f.iridescence>0&&(p.iridescence.value=f.iridescence,p.iridescenceIOR.value=f.iridescenceIOR,p.iridescenceThicknessMinimum.value=f.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=f.iridescenceThicknessMaximum,f.iridescenceMap&&(p.iridescenceMap.value=f.iridescenceMap,t(f.iridescenceMap,p.iridescenceMapTransform)),f.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=f.iridescenceThicknessMap,t(f.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),f.transmission>0&&(p.transmission.value=f.transmission,p.transmissionSamplerMap.value=v.texture,p.transmissionSamplerSize.value.set(v.width,v.height),f.transmissionMap&&(p.transmissionMap.value=f.transmissionMap,t(f.transmissionMap,p.transmissionMapTransform)),p.thickness.value=f.thickness,f.thicknessMap&&(p.thicknessMap.value=f.thicknessMap,t(f.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=f.attenuationDistance,p.attenuationColor.value.copy(f.attenuationColor)),f.anisotropy>0&&(p.anisotropyVector.value.set(f.anisotropy*Math.cos(f.anisotropyRotation),f.anisotropy*Math.sin(f.anisotropyRotation)),f.anisotropyMap&&(p.anisotropyMap.value=f.anisotropyMap,t(f.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=f.specularIntensity,p.specularColor.value.copy(f.specularColor),f.specularColorMap&&(p.specularColorMap.value=f.specularColorMap,t(f.specularColorMap,p.specularColorMapTransform)),f.specularIntensityMap&&(p.specularIntensityMap.value=f.specularIntensityMap,t(f.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,f){f.matcap&&(p.matcap.value=f.matcap)}function y(p,f){let v=e.get(f).light;p.referencePosition.value.setFromMatrixPosition(v.matrixWorld),p.nearDistance.value=v.shadow.camera.near,p.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function bT(i,e,t,n){let s={},r={};function o(v,M){let b=M.program;n.uniformBlockBinding(v,b,s[v.id])}function a(v,M){let b=s[v.id];b===void 0&&(g(v),b=l(v),s[v.id]=b,v.addEventListener("dispose",p));let E=M.program;n.updateUBOMapping(v,E);let T=e.render.frame;r[v.id]!==T&&(c(v),r[v.id]=T)}function l(v){let M=i.createBuffer(),b=v.__size,E=v.usage;return i.bindBuffer(i.UNIFORM_BUFFER,M),i.bufferData(i.UNIFORM_BUFFER,b,E),i.bindBuffer(i.UNIFORM_BUFFER,null),M}function c(v){let M=s[v.id],b=v.uniforms,E=v.__cache;i.bindBuffer(i.UNIFORM_BUFFER,M);for(let T=0,x=b.length;T<x;T++){let w=b[T];if(Array.isArray(w))for(let F=0,N=w.length;F<N;F++)h(w[F],T,F,E);else h(w,T,0,E)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(v,M,b,E){if(d(v,M,b,E)===!0){let T=v.__offset,x=v.value;if(Array.isArray(x)){let w=0;for(let F=0;F<x.length;F++){let N=x[F],R=y(N,!0);u(N,v.__data,w),w+=R.storage/Float32Array.BYTES_PER_ELEMENT}}else u(x,v.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,T,v.__data)}}function u(v,M,b){typeof v=="number"||typeof v=="boolean"?M[b]=v:v.isMatrix3?(M[b]=v.elements[0],M[b+1]=v.elements[1],M[b+2]=v.elements[2],M[b+3]=0,M[b+4]=v.elements[3],M[b+5]=v.elements[4],M[b+6]=v.elements[5],M[b+7]=0,M[b+8]=v.elements[6],M[b+9]=v.elements[7],M[b+10]=v.elements[8],M[b+11]=0):ArrayBuffer.isView(v)?M.set(v.subarray(0,M.length-b),b):v.toArray(M,b)}function d(v,M,b,E){let T=v.value,x=M+"_"+b;if(Array.isArray(T)){E[x]===void 0&&(E[x]=[]);let w=E[x],F=!1;for(let N=0;N<T.length;N++)m(T[N],w,N)===!0&&(F=!0);return F}return m(T,E,x)}function m(v,M,b){if(M[b]===void 0)return typeof v=="number"||typeof v=="boolean"?M[b]=v:ArrayBuffer.isView(v)?M[b]=v.slice():M[b]=v.clone(),!0;{let E=M[b];if(typeof v=="number"||typeof v=="boolean"){if(E!==v)return M[b]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(E.equals(v)===!1)return E.copy(v),!0}}return!1}function g(v){let M=v.uniforms,b=0,E=16;for(let x=0,w=M.length;x<w;x++){let F=Array.isArray(M[x])?M[x]:[M[x]];for(let N=0,R=F.length;N<R;N++){let U=F[N],k=Array.isArray(U.value)?U.value:[U.value],I=Array.isArray(M[x])||Array.isArray(U.value),H=b;for(let W=0,le=k.length;W<le;W++){let Z=k[W],q=y(Z,I),te=b%E,ce=te%q.boundary,he=te+ce;b+=ce,he!==0&&E-he<q.storage&&(b+=E-he),W===0&&(H=b),b+=q.storage}let Y=U.type==="int"?Int32Array:U.type==="uint"?Uint32Array:Float32Array;U.__data=new Y((b-H)/Float32Array.BYTES_PER_ELEMENT),U.__offset=H}}let T=b%E;return T>0&&(b+=E-T),v.__size=b,v.__cache={},this}function y(v,M){let b={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(b.boundary=4,b.storage=4):v.isVector2?(b.boundary=8,b.storage=8):v.isVector3||v.isColor?(b.boundary=16,b.storage=12):v.isVector4?(b.boundary=16,b.storage=16):v.isMatrix3?(b.boundary=16,b.storage=48):v.isMatrix4?(b.boundary=16,b.storage=64):v.isTexture?Ze("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(b.boundary=16,b.storage=v.byteLength):Ze("WebGLRenderer: Unsupported uniform value type.",v),M===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function p(v){let M=v.target;M.removeEventListener("dispose",p),i.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function f(){for(let v in s)i.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:f}}var MT=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),hs=null;function ST(){return hs===null&&(hs=new Ec(MT,16,16,ur,Gi),hs.name="DFG_LUT",hs.minFilter=Dn,hs.magFilter=Dn,hs.wrapS=os,hs.wrapT=os,hs.generateMipmaps=!1,hs.needsUpdate=!0),hs}var Dh=class{constructor(e={}){let{canvas:t=hy(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:m=yi}=e;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=o;let y=m,p=new Set([Qc,jc,Kc]),f=new Set([yi,zi,Bo,Nr,Jc,Zc]),v=new Uint32Array(4),M=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},E=null,T=null,x=[],w=[],F=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=cs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let N=this,R=!1,U=null,k=null,I=null,H=null;this._outputColorSpace=pi;let Y=0,W=0,le=null,Z=-1,q=null,te=new Qt,ce=new Qt,he=null,Q=new bt(0),me=0,ge=t.width,Ae=t.height,Me=1,Xe=null,rt=null,He=new Qt(0,0,ge,Ae),ut=new Qt(0,0,ge,Ae),lt=!1,it=new Rr,$t=new Tc,Bt=!1,ln=!1,Dt=new zt,wn=new V,Mt=new Qt,gn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},en=!1;function cn(){return le===null?Me:1}let z=n;function Re(C,G){return t.getContext(C,G)}let Je,ot,Se,Ft,Ve,Ye,P,S,$,de,oe,ve,xe,ne,se,pe,B,re,ie,we,ye,be,We;try{let C={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ke,!1),t.addEventListener("webglcontextrestored",Qe,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),z===null){let G="webgl2";if(z=Re(G,C),z===null)throw Re(G)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}je()}catch(C){throw t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",Qe,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),tt("WebGLRenderer: "+C.message),C}function je(){Je=new D1(z),Je.init(),ye=new gT(z,Je),ot=new S1(z,Je,e,ye),Se=new pT(z,Je),ot.reversedDepthBuffer&&d&&Se.buffers.depth.setReversed(!0),k=z.createFramebuffer(),I=z.createFramebuffer(),H=z.createFramebuffer(),Ft=new O1(z),Ve=new eT,Ye=new mT(z,Je,Se,Ve,ot,ye,Ft),P=new N1(N),S=new BM(z),be=new b1(z,S),$=new U1(z,S,Ft,be),de=new B1(z,$,S,be,Ft),re=new k1(z,ot,Ye),se=new w1(Ve),oe=new QE(N,P,Je,ot,be,se),ve=new _T(N,Ve),xe=new nT,ne=new lT(Je),B=new _1(N,P,Se,de,g,l),pe=new fT(N,de,ot),We=new bT(z,Ft,ot,Se),ie=new M1(z,Je,Ft),we=new F1(z,Je,Ft),Ft.programs=oe.programs,N.capabilities=ot,N.extensions=Je,N.properties=Ve,N.renderLists=xe,N.shadowMap=pe,N.state=Se,N.info=Ft}y!==yi&&(F=new V1(y,t.width,t.height,a,s,r));let ue=new Ff(N,z);this.xr=ue,this.getContext=function(){return z},this.getContextAttributes=function(){return z.getContextAttributes()},this.forceContextLoss=function(){let C=Je.get("WEBGL_lose_context");C&&C.loseContext()},this.forceContextRestore=function(){let C=Je.get("WEBGL_lose_context");C&&C.restoreContext()},this.getPixelRatio=function(){return Me},this.setPixelRatio=function(C){C!==void 0&&(Me=C,this.setSize(ge,Ae,!1))},this.getSize=function(C){return C.set(ge,Ae)},this.setSize=function(C,G,ee=!0){if(ue.isPresenting){Ze("WebGLRenderer: Can't change size while VR device is presenting.");return}ge=C,Ae=G,t.width=Math.floor(C*Me),t.height=Math.floor(G*Me),ee===!0&&(t.style.width=C+"px",t.style.height=G+"px"),F!==null&&F.setSize(t.width,t.height),this.setViewport(0,0,C,G)},this.getDrawingBufferSize=function(C){return C.set(ge*Me,Ae*Me).floor()},this.setDrawingBufferSize=function(C,G,ee){ge=C,Ae=G,Me=ee,t.width=Math.floor(C*ee),t.height=Math.floor(G*ee),this.setViewport(0,0,C,G)},this.setEffects=function(C){if(y===yi){tt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(C){for(let G=0;G<C.length;G++)if(C[G].isOutputPass===!0){Ze("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}F.setEffects(C||[])},this.getCurrentViewport=function(C){return C.copy(te)},this.getViewport=function(C){return C.copy(He)},this.setViewport=function(C,G,ee,J){C.isVector4?He.set(C.x,C.y,C.z,C.w):He.set(C,G,ee,J),Se.viewport(te.copy(He).multiplyScalar(cn()).round())},this.getScissor=function(C){return C.copy(ut)},this.setScissor=function(C,G,ee,J){C.isVector4?ut.set(C.x,C.y,C.z,C.w):ut.set(C,G,ee,J),Se.scissor(ce.copy(ut).multiplyScalar(cn()).round())},this.getScissorTest=function(){return lt},this.setScissorTest=function(C){Se.setScissorTest(lt=C)},this.setOpaqueSort=function(C){Xe=C},this.setTransparentSort=function(C){rt=C},this.getClearColor=function(C){return C.copy(B.getClearColor())},this.setClearColor=function(){B.setClearColor(...arguments)},this.getClearAlpha=function(){return B.getClearAlpha()},this.setClearAlpha=function(){B.setClearAlpha(...arguments)},this.clear=function(C=!0,G=!0,ee=!0){let J=0;if(C){let K=!1;if(le!==null){let Ee=le.texture.format;K=p.has(Ee)}if(K){let Ee=le.texture.type,Pe=f.has(Ee),Te=B.getClearColor(),Ie=B.getClearAlpha(),ze=Te.r,et=Te.g,ft=Te.b;Pe?(v[0]=ze,v[1]=et,v[2]=ft,v[3]=Ie,z.clearBufferuiv(z.COLOR,0,v)):(M[0]=ze,M[1]=et,M[2]=ft,M[3]=Ie,z.clearBufferiv(z.COLOR,0,M))}else J|=z.COLOR_BUFFER_BIT}G&&(J|=z.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),ee&&(J|=z.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),J!==0&&z.clear(J)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(C){C.setRenderer(this),U=C},this.dispose=function(){t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",Qe,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),B.dispose(),xe.dispose(),ne.dispose(),Ye.dispose(),Ve.dispose(),P.dispose(),de.dispose(),$.dispose(),be.dispose(),We.dispose(),oe.dispose(),ue.dispose(),ue.removeEventListener("sessionstart",ja),ue.removeEventListener("sessionend",Xi),ds.stop()};function ke(C){C.preventDefault(),bf("WebGLRenderer: Context Lost."),R=!0}function Qe(){bf("WebGLRenderer: Context Restored."),R=!1;let C=Ft.autoReset,G=pe.enabled,ee=pe.autoUpdate,J=pe.needsUpdate,K=pe.type;je(),Ft.autoReset=C,pe.enabled=G,pe.autoUpdate=ee,pe.needsUpdate=J,pe.type=K}function Ce(C){tt("WebGLRenderer: A WebGL context could not be created. Reason: ",C.statusMessage)}function at(C){let G=C.target;G.removeEventListener("dispose",at),Vt(G)}function Vt(C){Wn(C),Ve.remove(C)}function Wn(C){let G=Ve.get(C).programs;G!==void 0&&(G.forEach(function(ee){oe.releaseProgram(ee)}),C.isShaderMaterial&&oe.releaseShaderCache(C))}this.renderBufferDirect=function(C,G,ee,J,K,Ee){G===null&&(G=gn);let Pe=K.isMesh&&K.matrixWorld.determinantAffine()<0,Te=jo(C,G,ee,J,K);Se.setMaterial(J,Pe);let Ie=ee.index,ze=1;if(J.wireframe===!0){if(Ie=$.getWireframeAttribute(ee),Ie===void 0)return;ze=2}let et=ee.drawRange,ft=ee.attributes.position,Be=et.start*ze,pt=(et.start+et.count)*ze;Ee!==null&&(Be=Math.max(Be,Ee.start*ze),pt=Math.min(pt,(Ee.start+Ee.count)*ze)),Ie!==null?(Be=Math.max(Be,0),pt=Math.min(pt,Ie.count)):ft!=null&&(Be=Math.max(Be,0),pt=Math.min(pt,ft.count));let jt=pt-Be;if(jt<0||jt===1/0)return;be.setup(K,J,Te,ee,Ie);let It,Lt=ie;if(Ie!==null&&(It=S.get(Ie),Lt=we,Lt.setIndex(It)),K.isMesh)J.wireframe===!0?(Se.setLineWidth(J.wireframeLinewidth*cn()),Lt.setMode(z.LINES)):Lt.setMode(z.TRIANGLES);else if(K.isLine){let yn=J.linewidth;yn===void 0&&(yn=1),Se.setLineWidth(yn*cn()),K.isLineSegments?Lt.setMode(z.LINES):K.isLineLoop?Lt.setMode(z.LINE_LOOP):Lt.setMode(z.LINE_STRIP)}else K.isPoints?Lt.setMode(z.POINTS):K.isSprite&&Lt.setMode(z.TRIANGLES);if(K.isBatchedMesh)if(Je.get("WEBGL_multi_draw"))Lt.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let yn=K._multiDrawStarts,Fe=K._multiDrawCounts,hn=K._multiDrawCount,gt=Ie?S.get(Ie).bytesPerElement:1,ps=Ve.get(J).currentProgram.getUniforms();for(let un=0;un<hn;un++)ps.setValue(z,"_gl_DrawID",un),Lt.render(yn[un]/gt,Fe[un])}else if(K.isInstancedMesh)Lt.renderInstances(Be,jt,K.count);else if(ee.isInstancedBufferGeometry){let yn=ee._maxInstanceCount!==void 0?ee._maxInstanceCount:1/0,Fe=Math.min(ee.instanceCount,yn);Lt.renderInstances(Be,jt,Fe)}else Lt.render(Be,jt)};function Jo(C,G,ee,J){U!==null&&C.isNodeMaterial&&U.setObject(J,C),Bt===!0&&se.setState(C,ee,!1),C.transparent===!0&&C.side===ls&&C.forceSinglePass===!1?(C.side=ti,C.needsUpdate=!0,qi(C,G,J),C.side=hr,C.needsUpdate=!0,qi(C,G,J),C.side=ls):qi(C,G,J)}this.compile=function(C,G,ee=null){ee===null&&(ee=C),U!==null&&U.renderStart(C,G,ee),T=ne.get(ee),T.init(G),w.push(T),ee.traverseVisible(function(K){K.isLight&&K.layers.test(G.layers)&&(T.pushLight(K),K.castShadow&&T.pushShadow(K))}),C!==ee&&C.traverseVisible(function(K){K.isLight&&K.layers.test(G.layers)&&(T.pushLight(K),K.castShadow&&T.pushShadow(K))}),T.setupLights(),U!==null&&U.updateLights(T.state.lightsArray),ln=this.localClippingEnabled,Bt=se.init(this.clippingPlanes,ln),Bt===!0&&se.setGlobalState(this.clippingPlanes,G),U!==null&&pe.render(T.state.shadowsArray,ee,G);let J=new Set;return C.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let Ee=K.material;if(Ee)if(Array.isArray(Ee))for(let Pe=0;Pe<Ee.length;Pe++){let Te=Ee[Pe];Jo(Te,ee,G,K),J.add(Te)}else Jo(Ee,ee,G,K),J.add(Ee)}),T=w.pop(),U!==null&&U.renderEnd(),J},this.compileAsync=function(C,G,ee=null){let J=this.compile(C,G,ee);return new Promise(K=>{function Ee(){if(J.forEach(function(Pe){let Ie=Ve.get(Pe).currentProgram;(Ie===void 0||Ie.isReady())&&J.delete(Pe)}),J.size===0){K(C);return}setTimeout(Ee,10)}Je.get("KHR_parallel_shader_compile")!==null?Ee():setTimeout(Ee,10)})};let Ur=null;function ou(C){Ur&&Ur(C)}function ja(){ds.stop()}function Xi(){ds.start()}let ds=new zy;ds.setAnimationLoop(ou),typeof self<"u"&&ds.setContext(self),this.setAnimationLoop=function(C){Ur=C,ue.setAnimationLoop(C),C===null?ds.stop():ds.start()},ue.addEventListener("sessionstart",ja),ue.addEventListener("sessionend",Xi),this.render=function(C,G){if(G!==void 0&&G.isCamera!==!0){tt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(R===!0)return;U!==null&&U.renderStart(C,G);let ee=ue.enabled===!0&&ue.isPresenting===!0,J=F!==null&&(le===null||ee)&&F.begin(N,le);if(C.matrixWorldAutoUpdate===!0&&C.updateMatrixWorld(),G.parent===null&&G.matrixWorldAutoUpdate===!0&&G.updateMatrixWorld(),ue.enabled===!0&&ue.isPresenting===!0&&(F===null||F.isCompositing()===!1)&&(ue.cameraAutoUpdate===!0&&ue.updateCamera(G),G=ue.getCamera()),C.isScene===!0&&C.onBeforeRender(N,C,G,le),T=ne.get(C,w.length),T.init(G),T.state.textureUnits=Ye.getTextureUnits(),w.push(T),Dt.multiplyMatrices(G.projectionMatrix,G.matrixWorldInverse),G.isArrayCamera?$t.setFromArrayCamera(G):it.setFromProjectionMatrix(Dt,Ti,G.reversedDepth),ln=this.localClippingEnabled,Bt=se.init(this.clippingPlanes,ln),E=xe.get(C,x.length),E.init(),x.push(E),this.info.render.frame++,ue.enabled===!0&&ue.isPresenting===!0){let Pe=N.xr.getDepthSensingMesh();Pe!==null&&fs(Pe,G,-1/0,N.sortObjects)}fs(C,G,0,N.sortObjects),E.finish(),U!==null&&U.updateLights(T.state.lightsArray),N.sortObjects===!0&&E.sort(Xe,rt),en=ue.enabled===!1||ue.isPresenting===!1||ue.hasDepthSensing()===!1,en&&B.addToRenderList(E,C),this.info.autoReset===!0&&this.info.reset(),Bt===!0&&se.beginShadows();let K=T.state.shadowsArray;if(pe.render(K,C,G),Bt===!0&&se.endShadows(),(J&&F.hasRenderPass())===!1){let Pe=E.opaque,Te=E.transmissive;if(T.setupLights(),G.isArrayCamera){let Ie=G.cameras;if(Te.length>0)for(let ze=0,et=Ie.length;ze<et;ze++){let ft=Ie[ze];Ci(Pe,Te,C,ft)}en&&B.render(C);for(let ze=0,et=Ie.length;ze<et;ze++){let ft=Ie[ze];Zo(E,C,ft,ft.viewport)}}else Te.length>0&&Ci(Pe,Te,C,G),en&&B.render(C),Zo(E,C,G)}le!==null&&W===0&&(Ye.updateMultisampleRenderTarget(le),Ye.updateRenderTargetMipmap(le)),J&&F.end(N),C.isScene===!0&&C.onAfterRender(N,C,G),be.resetDefaultState(),Z=-1,q=null,w.pop(),w.length>0?(T=w[w.length-1],Ye.setTextureUnits(T.state.textureUnits),Bt===!0&&se.setGlobalState(N.clippingPlanes,T.state.camera)):T=null,x.pop(),x.length>0?E=x[x.length-1]:E=null,U!==null&&U.renderEnd()};function fs(C,G,ee,J){if(C.visible===!1)return;if(C.layers.test(G.layers)){if(C.isGroup)ee=C.renderOrder;else if(C.isLOD)C.autoUpdate===!0&&C.update(G);else if(C.isLight)T.pushLight(C),C.castShadow&&T.pushShadow(C);else if(C.isSprite){let Pe=G.isArrayCamera?$t:it;if(!C.frustumCulled||C.intersectsFrustum(Pe)){J&&Mt.setFromMatrixPosition(C.matrixWorld).applyMatrix4(Dt);let Te=de.update(C),Ie=C.material;Ie.visible&&E.push(C,Te,Ie,ee,Mt.z,null,G)}}else if(C.isMesh||C.isLine||C.isPoints){let Pe=G.isArrayCamera?$t:it;if(!C.frustumCulled||C.intersectsFrustum(Pe)){let Te=de.update(C),Ie=C.material;if(J&&(C.boundingSphere!==void 0?(C.boundingSphere===null&&C.computeBoundingSphere(),Mt.copy(C.boundingSphere.center)):(Te.boundingSphere===null&&Te.computeBoundingSphere(),Mt.copy(Te.boundingSphere.center)),Mt.applyMatrix4(C.matrixWorld).applyMatrix4(Dt)),Array.isArray(Ie)){let ze=Te.groups;for(let et=0,ft=ze.length;et<ft;et++){let Be=ze[et],pt=Ie[Be.materialIndex];pt&&pt.visible&&E.push(C,Te,pt,ee,Mt.z,Be,G)}}else Ie.visible&&E.push(C,Te,Ie,ee,Mt.z,null,G)}}}let Ee=C.children;for(let Pe=0,Te=Ee.length;Pe<Te;Pe++)fs(Ee[Pe],G,ee,J)}function Zo(C,G,ee,J){let{opaque:K,transmissive:Ee,transparent:Pe}=C;T.setupLightsView(ee),Bt===!0&&se.setGlobalState(N.clippingPlanes,ee),J&&Se.viewport(te.copy(J)),K.length>0&&tn(K,G,ee),Ee.length>0&&tn(Ee,G,ee),Pe.length>0&&tn(Pe,G,ee),Se.buffers.depth.setTest(!0),Se.buffers.depth.setMask(!0),Se.buffers.color.setMask(!0),Se.setPolygonOffset(!1)}function Ci(C,G,ee,J){if((ee.isScene===!0?ee.overrideMaterial:null)!==null)return;if(T.state.transmissionRenderTarget[J.id]===void 0){let Be=Je.has("EXT_color_buffer_half_float")||Je.has("EXT_color_buffer_float");T.state.transmissionRenderTarget[J.id]=new ei(1,1,{generateMipmaps:!0,type:Be?Gi:yi,minFilter:Bi,samples:Math.max(4,ot.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:vt.workingColorSpace})}let Ee=T.state.transmissionRenderTarget[J.id],Pe=J.viewport||te;Ee.setSize(Pe.z*N.transmissionResolutionScale,Pe.w*N.transmissionResolutionScale);let Te=N.getRenderTarget(),Ie=N.getActiveCubeFace(),ze=N.getActiveMipmapLevel();N.setRenderTarget(Ee),N.getClearColor(Q),me=N.getClearAlpha(),me<1&&N.setClearColor(16777215,.5),N.clear(),en&&B.render(ee);let et=N.toneMapping;N.toneMapping=cs;let ft=J.viewport;if(J.viewport!==void 0&&(J.viewport=void 0),T.setupLightsView(J),Bt===!0&&se.setGlobalState(N.clippingPlanes,J),tn(C,ee,J),Ye.updateMultisampleRenderTarget(Ee),Ye.updateRenderTargetMipmap(Ee),Je.has("WEBGL_multisampled_render_to_texture")===!1){let Be=!1;for(let pt=0,jt=G.length;pt<jt;pt++){let It=G[pt],{object:Lt,geometry:yn,material:Fe,group:hn}=It;if(Fe.side===ls&&Lt.layers.test(J.layers)){let gt=Fe.side;Fe.side=ti,Fe.needsUpdate=!0,on(Lt,ee,J,yn,Fe,hn),Fe.side=gt,Fe.needsUpdate=!0,Be=!0}}Be===!0&&(Ye.updateMultisampleRenderTarget(Ee),Ye.updateRenderTargetMipmap(Ee))}N.setRenderTarget(Te,Ie,ze),N.setClearColor(Q,me),ft!==void 0&&(J.viewport=ft),N.toneMapping=et}function tn(C,G,ee){let J=G.isScene===!0?G.overrideMaterial:null;for(let K=0,Ee=C.length;K<Ee;K++){let Pe=C[K],{object:Te,geometry:Ie,group:ze}=Pe,et=Pe.material;et.allowOverride===!0&&J!==null&&(et=J),Te.layers.test(ee.layers)&&on(Te,G,ee,Ie,et,ze)}}function on(C,G,ee,J,K,Ee){U!==null&&K.isNodeMaterial&&U.setObject(C,K),C.onBeforeRender(N,G,ee,J,K,Ee),C.modelViewMatrix.multiplyMatrices(ee.matrixWorldInverse,C.matrixWorld),C.normalMatrix.getNormalMatrix(C.modelViewMatrix),K.onBeforeRender(N,G,ee,J,C,Ee),K.transparent===!0&&K.side===ls&&K.forceSinglePass===!1?(K.side=ti,K.needsUpdate=!0,N.renderBufferDirect(ee,G,J,K,C,Ee),K.side=hr,K.needsUpdate=!0,N.renderBufferDirect(ee,G,J,K,C,Ee),K.side=ls):N.renderBufferDirect(ee,G,J,K,C,Ee),C.onAfterRender(N,G,ee,J,K,Ee)}function an(C){let G=0;for(let ee of C)ee.texture!==null&&G++;return G}function qi(C,G,ee){G.isScene!==!0&&(G=gn);let J=Ve.get(C),K=T.state.lights,Ee=T.state.shadowsArray,Pe=K.state.version,Te=oe.getParameters(C,K.state,Ee,G,ee,T.state.lightProbeGridArray),Ie=oe.getProgramCacheKey(Te),ze=J.programs;J.environment=C.isMeshStandardMaterial||C.isMeshLambertMaterial||C.isMeshPhongMaterial?G.environment:null,J.fog=G.fog;let et=C.isMeshStandardMaterial||C.isMeshLambertMaterial&&!C.envMap||C.isMeshPhongMaterial&&!C.envMap;J.envMap=P.get(C.envMap||J.environment,et),J.envMapRotation=J.environment!==null&&C.envMap===null?G.environmentRotation:C.envMapRotation,ze===void 0&&(C.addEventListener("dispose",at),ze=new Map,J.programs=ze,J.programVariants=new Map);let ft=ze.get(Ie);if(ft!==void 0){if(J.currentProgram===ft&&J.lightsStateVersion===Pe)return Ko(C,Te),ft}else Te.uniforms=oe.getUniforms(C),U!==null&&C.isNodeMaterial&&U.build(C,ee,Te),C.onBeforeCompile(Te,N),ft=oe.acquireProgram(Te,Ie),ze.set(Ie,ft),J.uniforms=Te.uniforms;let Be=J.uniforms;return(!C.isShaderMaterial&&!C.isRawShaderMaterial||C.clipping===!0)&&(Be.clippingPlanes=se.uniform),Ko(C,Te),J.needsLights=Fs(C),J.lightsStateVersion=Pe,J.needsLights&&(Be.ambientLightColor.value=K.state.ambient,Be.lightProbe.value=K.state.probe,Be.sunLights.value=K.state.sun,Be.sunLightShadows.value=K.state.sunShadow,Be.directionalLights.value=K.state.directional,Be.directionalLightShadows.value=K.state.directionalShadow,Be.spotLights.value=K.state.spot,Be.spotLightShadows.value=K.state.spotShadow,Be.rectAreaLights.value=K.state.rectArea,Be.ltc_1.value=K.state.rectAreaLTC1,Be.ltc_2.value=K.state.rectAreaLTC2,Be.pointLights.value=K.state.point,Be.pointLightShadows.value=K.state.pointShadow,Be.hemisphereLights.value=K.state.hemi,Be.sunShadowMatrix.value=K.state.sunShadowMatrix,Be.sunShadowCascade.value=K.state.sunShadowCascade,Be.directionalShadowMatrix.value=K.state.directionalShadowMatrix,Be.spotLightMatrix.value=K.state.spotLightMatrix,Be.spotLightMap.value=K.state.spotLightMap,Be.pointShadowMatrix.value=K.state.pointShadowMatrix),J.numLightProbeGrids=an(T.state.lightProbeGridArray),J.currentProgram=ft,J.uniformsList=null,ft}function si(C,G,ee,J,K){let Ee=Ve.get(C),Pe=Ee.currentProgram.id+","+J+","+K,Te=Ee.programVariants.get(Pe);return Te===void 0?(Te=qi(C,G,ee),Ee.programVariants.set(Pe,Te)):(Ee.currentProgram=Te,Ee.uniformsList=null,Ee.outputColorSpace=J,Ee.toneMapping=K),Te}function Us(C){if(C.uniformsList===null){let G=C.currentProgram.getUniforms();C.uniformsList=zo.seqWithValue(G.seq,C.uniforms)}return C.uniformsList}function Ko(C,G){let ee=Ve.get(C);ee.outputColorSpace=G.outputColorSpace,ee.batching=G.batching,ee.batchingColor=G.batchingColor,ee.instancing=G.instancing,ee.instancingColor=G.instancingColor,ee.instancingMorph=G.instancingMorph,ee.skinning=G.skinning,ee.morphTargets=G.morphTargets,ee.morphNormals=G.morphNormals,ee.morphColors=G.morphColors,ee.morphTargetsCount=G.morphTargetsCount,ee.numClippingPlanes=G.numClippingPlanes,ee.numIntersection=G.numClipIntersection,ee.vertexAlphas=G.vertexAlphas,ee.vertexTangents=G.vertexTangents,ee.toneMapping=G.toneMapping}function jo(C,G,ee,J,K){G.isScene!==!0&&(G=gn),Ye.resetTextureUnits();let Ee=G.fog,Pe=J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial?G.environment:null,Te=le===null?N.outputColorSpace:le.isXRRenderTarget===!0?le.texture.colorSpace:vt.workingColorSpace,Ie=J.isMeshStandardMaterial||J.isMeshLambertMaterial&&!J.envMap||J.isMeshPhongMaterial&&!J.envMap,ze=P.get(J.envMap||Pe,Ie),et=J.vertexColors===!0&&!!ee.attributes.color&&ee.attributes.color.itemSize===4,ft=!!ee.attributes.tangent&&(!!J.normalMap||J.anisotropy>0),Be=!!ee.morphAttributes.position,pt=!!ee.morphAttributes.normal,jt=!!ee.morphAttributes.color,It=cs;J.toneMapped&&(le===null||le.isXRRenderTarget===!0)&&(It=N.toneMapping);let Lt=ee.morphAttributes.position||ee.morphAttributes.normal||ee.morphAttributes.color,yn=Lt!==void 0?Lt.length:0,Fe=Ve.get(J),hn=T.state.lights;if(Bt===!0&&(ln===!0||C!==q)){let Nt=C===q&&J.id===Z;se.setState(J,C,Nt)}let gt=!1,ps=!1;J.version===Fe.__version?Fe.needsLights&&Fe.lightsStateVersion!==hn.state.version||K.isBatchedMesh&&Fe.batching===!1||!K.isBatchedMesh&&Fe.batching===!0||K.isBatchedMesh&&Fe.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&Fe.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&Fe.instancing===!1||!K.isInstancedMesh&&Fe.instancing===!0||K.isSkinnedMesh&&Fe.skinning===!1||!K.isSkinnedMesh&&Fe.skinning===!0||K.isInstancedMesh&&Fe.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&Fe.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&Fe.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&Fe.instancingMorph===!1&&K.morphTexture!==null||Fe.envMap!==ze||J.fog===!0&&Fe.fog!==Ee||Fe.numClippingPlanes!==void 0&&(Fe.numClippingPlanes!==se.numPlanes||Fe.numIntersection!==se.numIntersection)||Fe.vertexAlphas!==et||Fe.vertexTangents!==ft||Fe.morphTargets!==Be||Fe.morphNormals!==pt||Fe.morphColors!==jt||Fe.morphTargetsCount!==yn||Fe.numLightProbeGrids!==an(T.state.lightProbeGridArray)?gt=!0:(Fe.outputColorSpace!==Te||Fe.toneMapping!==It)&&(ps=!0):(gt=!0,Fe.__version=J.version);let un=Fe.currentProgram;(gt===!0||ps===!0)&&(un=ps===!0?si(J,G,K,Te,It):qi(J,G,K),U&&J.isNodeMaterial&&U.onUpdateProgram(J,un,Fe));let kr=!1,$i=!1,ms=!1,ct=un.getUniforms(),nn=Fe.uniforms;if(Se.useProgram(un.program)&&(kr=!0,$i=!0,ms=!0),J.id!==Z&&(Z=J.id,$i=!0),kr||q!==C){Se.buffers.depth.getReversed()&&C.reversedDepth!==!0&&(C._reversedDepth=!0,C.updateProjectionMatrix()),ct.setValue(z,"projectionMatrix",C.projectionMatrix),ct.setValue(z,"viewMatrix",C.matrixWorldInverse);let dn=ct.map.cameraPosition;dn!==void 0&&dn.setValue(z,wn.setFromMatrixPosition(C.matrixWorld)),ot.logarithmicDepthBuffer&&ct.setValue(z,"logDepthBufFC",2/(Math.log(C.far+1)/Math.LN2)),(J.isMeshPhongMaterial||J.isMeshToonMaterial||J.isMeshLambertMaterial||J.isMeshBasicMaterial||J.isMeshStandardMaterial||J.isShaderMaterial)&&ct.setValue(z,"isOrthographic",C.isOrthographicCamera===!0),q!==C&&(q=C,$i=!0,ms=!0)}if(Fe.needsLights&&(hn.state.sunShadowMap.length>0&&ct.setValue(z,"sunShadowMap",hn.state.sunShadowMap,Ye),hn.state.directionalShadowMap.length>0&&ct.setValue(z,"directionalShadowMap",hn.state.directionalShadowMap,Ye),hn.state.spotShadowMap.length>0&&ct.setValue(z,"spotShadowMap",hn.state.spotShadowMap,Ye),hn.state.pointShadowMap.length>0&&ct.setValue(z,"pointShadowMap",hn.state.pointShadowMap,Ye)),K.isSkinnedMesh){ct.setOptional(z,K,"bindMatrix"),ct.setOptional(z,K,"bindMatrixInverse");let Nt=K.skeleton;Nt&&(Nt.boneTexture===null&&Nt.computeBoneTexture(),ct.setValue(z,"boneTexture",Nt.boneTexture,Ye))}K.isBatchedMesh&&(ct.setOptional(z,K,"batchingTexture"),ct.setValue(z,"batchingTexture",K._matricesTexture,Ye),ct.setOptional(z,K,"batchingIdTexture"),ct.setValue(z,"batchingIdTexture",K._indirectTexture,Ye),ct.setOptional(z,K,"batchingColorTexture"),K._colorsTexture!==null&&ct.setValue(z,"batchingColorTexture",K._colorsTexture,Ye));let Xn=ee.morphAttributes;if((Xn.position!==void 0||Xn.normal!==void 0||Xn.color!==void 0)&&re.update(K,ee,un),($i||Fe.receiveShadow!==K.receiveShadow)&&(Fe.receiveShadow=K.receiveShadow,ct.setValue(z,"receiveShadow",K.receiveShadow)),(J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial)&&J.envMap===null&&G.environment!==null&&(nn.envMapIntensity.value=G.environmentIntensity),nn.dfgLUT!==void 0&&(nn.dfgLUT.value=ST()),$i){if(ct.setValue(z,"toneMappingExposure",N.toneMappingExposure),Fe.needsLights&&Fr(nn,ms),Ee&&J.fog===!0&&ve.refreshFogUniforms(nn,Ee),ve.refreshMaterialUniforms(nn,J,Me,Ae,T.state.transmissionRenderTarget[C.id]),Fe.needsLights&&Fe.numLightProbeGrids>0){let Nt=b,dn=0;for(let Fn of T.state.lightProbeGridArray)Fn.texture!==null&&(Nt.textures[dn]=Fn.texture,Nt.min[dn]=Fn.boundingBox.min,Nt.max[dn]=Fn.boundingBox.max,Nt.resolution[dn]=Fn.resolution,dn++);for(let Fn in Nt)Nt[Fn].length=dn;nn.probesSH.value=Nt.textures,nn.probesMin.value=Nt.min,nn.probesMax.value=Nt.max,nn.probesResolution.value=Nt.resolution}zo.upload(z,Us(Fe),nn,Ye)}if(J.isShaderMaterial&&J.uniformsNeedUpdate===!0&&(zo.upload(z,Us(Fe),nn,Ye),J.uniformsNeedUpdate=!1),J.isSpriteMaterial&&ct.setValue(z,"center",K.center),ct.setValue(z,"modelViewMatrix",K.modelViewMatrix),ct.setValue(z,"normalMatrix",K.normalMatrix),ct.setValue(z,"modelMatrix",K.matrixWorld),J.uniformsGroups!==void 0){let Nt=J.uniformsGroups;for(let dn=0,Fn=Nt.length;dn<Fn;dn++){let Qa=Nt[dn];We.update(Qa,un),We.bind(Qa,un)}}return un}function Fr(C,G){C.ambientLightColor.needsUpdate=G,C.lightProbe.needsUpdate=G,C.sunLights.needsUpdate=G,C.sunLightShadows.needsUpdate=G,C.directionalLights.needsUpdate=G,C.directionalLightShadows.needsUpdate=G,C.pointLights.needsUpdate=G,C.pointLightShadows.needsUpdate=G,C.spotLights.needsUpdate=G,C.spotLightShadows.needsUpdate=G,C.rectAreaLights.needsUpdate=G,C.hemisphereLights.needsUpdate=G}function Fs(C){return C.isMeshLambertMaterial||C.isMeshToonMaterial||C.isMeshPhongMaterial||C.isMeshStandardMaterial||C.isShadowMaterial||C.isShaderMaterial&&C.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return W},this.getRenderTarget=function(){return le},this.setRenderTargetTextures=function(C,G,ee){let J=Ve.get(C);J.__autoAllocateDepthBuffer=C.resolveDepthBuffer===!1,J.__autoAllocateDepthBuffer===!1&&(J.__useRenderToTexture=!1),Ve.get(C.texture).__webglTexture=G,Ve.get(C.depthTexture).__webglTexture=J.__autoAllocateDepthBuffer?void 0:ee,J.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(C,G){let ee=Ve.get(C);ee.__webglFramebuffer=G,ee.__useDefaultFramebuffer=G===void 0},this.setRenderTarget=function(C,G=0,ee=0){le=C,Y=G,W=ee;let J=null,K=!1,Ee=!1;if(C){let Te=Ve.get(C);if(Te.__useDefaultFramebuffer!==void 0){Se.bindFramebuffer(z.FRAMEBUFFER,Te.__webglFramebuffer),te.copy(C.viewport),ce.copy(C.scissor),he=C.scissorTest,Se.viewport(te),Se.scissor(ce),Se.setScissorTest(he),Z=-1;return}else if(Te.__webglFramebuffer===void 0)Ye.setupRenderTarget(C);else if(Te.__hasExternalTextures)Ye.rebindTextures(C,Ve.get(C.texture).__webglTexture,Ve.get(C.depthTexture).__webglTexture);else if(C.depthBuffer){let et=C.depthTexture;if(Te.__boundDepthTexture!==et){if(et!==null&&Ve.has(et)&&(C.width!==et.image.width||C.height!==et.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ye.setupDepthRenderbuffer(C)}}let Ie=C.texture;(Ie.isData3DTexture||Ie.isDataArrayTexture||Ie.isCompressedArrayTexture)&&(Ee=!0);let ze=Ve.get(C).__webglFramebuffer;C.isWebGLCubeRenderTarget?(Array.isArray(ze[G])?J=ze[G][ee]:J=ze[G],K=!0):C.samples>0&&Ye.useMultisampledRTT(C)===!1?J=Ve.get(C).__webglMultisampledFramebuffer:Array.isArray(ze)?J=ze[ee]:J=ze,te.copy(C.viewport),ce.copy(C.scissor),he=C.scissorTest}else te.copy(He).multiplyScalar(Me).floor(),ce.copy(ut).multiplyScalar(Me).floor(),he=lt;if(ee!==0&&(J=k),Se.bindFramebuffer(z.FRAMEBUFFER,J)&&Se.drawBuffers(C,J),Se.viewport(te),Se.scissor(ce),Se.setScissorTest(he),K){let Te=Ve.get(C.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_CUBE_MAP_POSITIVE_X+G,Te.__webglTexture,ee)}else if(Ee){let Te=G;for(let Ie=0;Ie<C.textures.length;Ie++){let ze=Ve.get(C.textures[Ie]);z.framebufferTextureLayer(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0+Ie,ze.__webglTexture,ee,Te)}}else if(C!==null&&ee!==0){let Te=Ve.get(C.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,Te.__webglTexture,ee)}Z=-1};function Or(C){let G=Ve.get(C);return(G.__readFormat!==C.format||G.__readType!==C.type)&&(G.__readFormat=C.format,G.__readType=C.type,G.__formatReadable=ot.textureFormatReadable(C.format),G.__typeReadable=ot.textureTypeReadable(C.type)),G}this.readRenderTargetPixels=function(C,G,ee,J,K,Ee,Pe,Te=0){if(!(C&&C.isWebGLRenderTarget)){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ie=Ve.get(C).__webglFramebuffer;if(C.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie){Se.bindFramebuffer(z.FRAMEBUFFER,Ie);try{let ze=C.textures[Te],et=ze.format,ft=ze.type;C.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+Te);let Be=Or(ze);if(Be.__formatReadable===!1){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Be.__typeReadable===!1){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}G>=0&&G<=C.width-J&&ee>=0&&ee<=C.height-K&&z.readPixels(G,ee,J,K,ye.convert(et),ye.convert(ft),Ee)}finally{let ze=le!==null?Ve.get(le).__webglFramebuffer:null;Se.bindFramebuffer(z.FRAMEBUFFER,ze)}}},this.readRenderTargetPixelsAsync=async function(C,G,ee,J,K,Ee,Pe,Te=0){if(!(C&&C.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ie=Ve.get(C).__webglFramebuffer;if(C.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie)if(G>=0&&G<=C.width-J&&ee>=0&&ee<=C.height-K){Se.bindFramebuffer(z.FRAMEBUFFER,Ie);let ze=C.textures[Te],et=ze.format,ft=ze.type;C.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+Te);let Be=Or(ze);if(Be.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Be.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let pt=z.createBuffer();z.bindBuffer(z.PIXEL_PACK_BUFFER,pt),z.bufferData(z.PIXEL_PACK_BUFFER,Ee.byteLength,z.STREAM_READ),z.readPixels(G,ee,J,K,ye.convert(et),ye.convert(ft),0),z.bindBuffer(z.PIXEL_PACK_BUFFER,null);let jt=le!==null?Ve.get(le).__webglFramebuffer:null;Se.bindFramebuffer(z.FRAMEBUFFER,jt);let It=z.fenceSync(z.SYNC_GPU_COMMANDS_COMPLETE,0);return z.flush(),await dy(z,It,4),z.bindBuffer(z.PIXEL_PACK_BUFFER,pt),z.getBufferSubData(z.PIXEL_PACK_BUFFER,0,Ee),z.bindBuffer(z.PIXEL_PACK_BUFFER,null),z.deleteBuffer(pt),z.deleteSync(It),Ee}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(C,G=null,ee=0){let J=Math.pow(2,-ee),K=Math.floor(C.image.width*J),Ee=Math.floor(C.image.height*J),Pe=G!==null?G.x:0,Te=G!==null?G.y:0;Ye.setTexture2D(C,0),z.copyTexSubImage2D(z.TEXTURE_2D,ee,0,0,Pe,Te,K,Ee),Se.unbindTexture()},this.copyTextureToTexture=function(C,G,ee=null,J=null,K=0,Ee=0){let Pe,Te,Ie,ze,et,ft,Be,pt,jt,It=C.isCompressedTexture?C.mipmaps[Ee]:C.image;if(ee!==null)Pe=ee.max.x-ee.min.x,Te=ee.max.y-ee.min.y,Ie=ee.isBox3?ee.max.z-ee.min.z:1,ze=ee.min.x,et=ee.min.y,ft=ee.isBox3?ee.min.z:0;else{let ct=Math.pow(2,-K);Pe=Math.floor(It.width*ct),Te=Math.floor(It.height*ct),C.isDataArrayTexture?Ie=It.depth:C.isData3DTexture?Ie=Math.floor(It.depth*ct):Ie=1,ze=0,et=0,ft=0}J!==null?(Be=J.x,pt=J.y,jt=J.z):(Be=0,pt=0,jt=0);let Lt=ye.convert(G.format),yn=ye.convert(G.type),Fe;G.isData3DTexture?(Ye.setTexture3D(G,0),Fe=z.TEXTURE_3D):G.isDataArrayTexture||G.isCompressedArrayTexture?(Ye.setTexture2DArray(G,0),Fe=z.TEXTURE_2D_ARRAY):(Ye.setTexture2D(G,0),Fe=z.TEXTURE_2D),Se.activeTexture(z.TEXTURE0),Se.pixelStorei(z.UNPACK_FLIP_Y_WEBGL,G.flipY),Se.pixelStorei(z.UNPACK_PREMULTIPLY_ALPHA_WEBGL,G.premultiplyAlpha),Se.pixelStorei(z.UNPACK_ALIGNMENT,G.unpackAlignment);let hn=Se.getParameter(z.UNPACK_ROW_LENGTH),gt=Se.getParameter(z.UNPACK_IMAGE_HEIGHT),ps=Se.getParameter(z.UNPACK_SKIP_PIXELS),un=Se.getParameter(z.UNPACK_SKIP_ROWS),kr=Se.getParameter(z.UNPACK_SKIP_IMAGES);Se.pixelStorei(z.UNPACK_ROW_LENGTH,It.width),Se.pixelStorei(z.UNPACK_IMAGE_HEIGHT,It.height),Se.pixelStorei(z.UNPACK_SKIP_PIXELS,ze),Se.pixelStorei(z.UNPACK_SKIP_ROWS,et),Se.pixelStorei(z.UNPACK_SKIP_IMAGES,ft);let $i=C.isDataArrayTexture||C.isData3DTexture,ms=G.isDataArrayTexture||G.isData3DTexture;if(C.isDepthTexture){let ct=Ve.get(C),nn=Ve.get(G),Xn=Ve.get(ct.__renderTarget),Nt=Ve.get(nn.__renderTarget);Se.bindFramebuffer(z.READ_FRAMEBUFFER,Xn.__webglFramebuffer),Se.bindFramebuffer(z.DRAW_FRAMEBUFFER,Nt.__webglFramebuffer);for(let dn=0;dn<Ie;dn++)$i&&(z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,Ve.get(C).__webglTexture,K,ft+dn),z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,Ve.get(G).__webglTexture,Ee,jt+dn)),z.blitFramebuffer(ze,et,ze+Pe,et+Te,Be,pt,Be+Pe,pt+Te,z.DEPTH_BUFFER_BIT,z.NEAREST);Se.bindFramebuffer(z.READ_FRAMEBUFFER,null),Se.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else if(K!==0||C.isRenderTargetTexture||Ve.has(C)){let ct=Ve.get(C),nn=Ve.get(G);Se.bindFramebuffer(z.READ_FRAMEBUFFER,I),Se.bindFramebuffer(z.DRAW_FRAMEBUFFER,H);for(let Xn=0;Xn<Ie;Xn++)$i?z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,ct.__webglTexture,K,ft+Xn):z.framebufferTexture2D(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,ct.__webglTexture,K),ms?z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,nn.__webglTexture,Ee,jt+Xn):z.framebufferTexture2D(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,nn.__webglTexture,Ee),K!==0?z.blitFramebuffer(ze,et,ze+Pe,et+Te,Be,pt,Be+Pe,pt+Te,z.COLOR_BUFFER_BIT,z.NEAREST):ms?z.copyTexSubImage3D(Fe,Ee,Be,pt,jt+Xn,ze,et,Pe,Te):z.copyTexSubImage2D(Fe,Ee,Be,pt,ze,et,Pe,Te);Se.bindFramebuffer(z.READ_FRAMEBUFFER,null),Se.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else ms?C.isDataTexture||C.isData3DTexture?z.texSubImage3D(Fe,Ee,Be,pt,jt,Pe,Te,Ie,Lt,yn,It.data):G.isCompressedArrayTexture?z.compressedTexSubImage3D(Fe,Ee,Be,pt,jt,Pe,Te,Ie,Lt,It.data):z.texSubImage3D(Fe,Ee,Be,pt,jt,Pe,Te,Ie,Lt,yn,It):C.isDataTexture?z.texSubImage2D(z.TEXTURE_2D,Ee,Be,pt,Pe,Te,Lt,yn,It.data):C.isCompressedTexture?z.compressedTexSubImage2D(z.TEXTURE_2D,Ee,Be,pt,It.width,It.height,Lt,It.data):z.texSubImage2D(z.TEXTURE_2D,Ee,Be,pt,Pe,Te,Lt,yn,It);Se.pixelStorei(z.UNPACK_ROW_LENGTH,hn),Se.pixelStorei(z.UNPACK_IMAGE_HEIGHT,gt),Se.pixelStorei(z.UNPACK_SKIP_PIXELS,ps),Se.pixelStorei(z.UNPACK_SKIP_ROWS,un),Se.pixelStorei(z.UNPACK_SKIP_IMAGES,kr),Ee===0&&G.generateMipmaps===!0&&G.mipmapsAutoUpdate===!0&&z.generateMipmap(Fe),Se.unbindTexture()},this.initRenderTarget=function(C){Ve.get(C).__webglFramebuffer===void 0&&Ye.setupRenderTarget(C)},this.initTexture=function(C){C.isCubeTexture?Ye.setTextureCube(C,0):C.isData3DTexture?Ye.setTexture3D(C,0):C.isDataArrayTexture||C.isCompressedArrayTexture?Ye.setTexture2DArray(C,0):Ye.setTexture2D(C,0),Se.unbindTexture()},this.resetState=function(){Y=0,W=0,le=null,Se.reset(),be.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ti}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=vt._getDrawingBufferColorSpace(e),t.unpackColorSpace=vt._getUnpackColorSpace()}};var Wi=new V,Ky=new V,jy=new V,Go=new V,Qy=new zt;function Ho(i,e,t,n){let s=new V(2*(t-e.x)/e.width-1,1-2*(n-e.y)/e.height,.5).unproject(i);return new sr(i.position.clone(),s.sub(i.position).normalize())}function Oh(i,e,t,n,s,r){let{shape:o,places:a}=i,l=(y,p)=>p.fromArray(a,3*y),c=Ho(e,t,n,s),h=1/0,u=-1,d=new V;if(o.triangles){for(let y=0;y<o.triangles.length;y+=3){let[p,f,v]=[o.triangles[y],o.triangles[y+1],o.triangles[y+2]];if(!c.intersectTriangle(l(p,Wi),l(f,Ky),l(v,jy),!1,Go))continue;let M=Go.distanceToSquared(c.origin);if(M>=h)continue;h=M,d.copy(Go);let[b,E,T]=[Wi.distanceToSquared(Go),Ky.distanceToSquared(Go),jy.distanceToSquared(Go)];u=b<=E&&b<=T?p:E<=T?f:v}if(u>=0)return{point:o.point[u],place:l(u,new V),surface:d}}Qy.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse);let m=r*r;for(let y=0;y<o.corners;y++){l(y,Wi).applyMatrix4(Qy);let p=t.x+(Wi.x+1)/2*t.width-n,f=t.y+(1-Wi.y)/2*t.height-s,v=p*p+f*f+40*Wi.z;Wi.z<1&&p*p+f*f<r*r&&v-40<m&&(m=v-40,u=y)}if(u<0)return null;let g=l(u,new V);return{point:o.point[u],place:g,surface:g.clone()}}function kh(i,e,t){return Wi.copy(t).project(i),Wi.z>1?null:{x:e.x+(Wi.x+1)/2*e.width,y:e.y+(1-Wi.y)/2*e.height}}var wT=30,Of=14,ET=6,TT=.15,Bh=class{constructor(e,t){this.picture=e;this.store=t;let{canvas:n}=e,s=(r,o,a,l=!0)=>{r.addEventListener(o,a,{passive:l}),this.ends.push(()=>r.removeEventListener(o,a))};s(n,"pointerdown",r=>this.down(r)),s(n,"pointermove",r=>this.move(r)),s(n,"pointerrawupdate",r=>this.raw(r)),s(n,"pointerup",r=>this.up(r)),s(n,"pointercancel",r=>this.up(r)),s(n,"pointerleave",()=>this.leave()),s(n,"wheel",r=>this.wheel(r),!1),s(n,"contextmenu",r=>r.preventDefault(),!1),s(n,"dblclick",r=>this.double(r)),s(window,"keydown",r=>this.key(r),!1),s(window,"blur",()=>this.release())}picture;store;pointers=new Map;doing=null;holder=-1;moved=0;over=null;ends=[];pads=new co;dispose(){this.release();for(let e of this.ends)e()}release(){this.picture.hold.release(),this.doing==="hold"&&(this.doing=null),this.holder=-1,this.picture.draw()}step(e){let{hold:t,orbit:n}=this.picture,s=this.doing==="hold"&&this.moved<ET&&t.push(e,n.axes()[2]);this.over&&this.picture.hover(!t.holds&&this.picture.mayAct()?this.picture.pick(this.over.x,this.over.y,Of):null);let r=this.pads.read();if(!r)return s;if(r.pressed&&!t.holds&&this.grabCentre(),r.released&&t.holds&&t.release(),t.holds&&Math.hypot(r.x,r.y,r.depth)>TT){let[o,a,l]=n.axes(),c=1.2*n.metres(this.picture.ownCell().height)*this.picture.ownCell().height*.5*e;t.shift(o.multiplyScalar(r.x*c).addScaledVector(a,-r.y*c).addScaledVector(l,r.depth*c)),s=!0}return this.pads.rumble(t.holds?this.picture.force():0),s||t.holds}at(e){let t=this.picture.canvas.getBoundingClientRect();return{x:e.clientX-t.left,y:e.clientY-t.top}}down(e){let{canvas:t,hold:n,orbit:s}=this.picture,r=this.at(e);if(t.setPointerCapture(e.pointerId),this.pointers.set(e.pointerId,r),this.moved=0,e.pointerType==="touch"&&this.pointers.size===2){this.doing==="hold"&&n.release(),this.doing="two";return}if(!(this.pointers.size>1)){if(e.button===1||e.button===0&&e.shiftKey)this.doing="pan";else if(e.button===2||e.ctrlKey)this.doing="turn";else{let o=this.picture.mayAct()?this.picture.pick(r.x,r.y,e.pointerType==="touch"?wT:Of):null;if(this.doing=o?"hold":"turn",o){this.holder=e.pointerId;let a=s.axes()[2];this.store.settings.tool==="ball"?n.press(o.surface,a,e.timeStamp):n.grab(o.point,o.place,o.surface,a,e.timeStamp),this.picture.hover(null)}}t.dataset.doing=this.doing,this.picture.draw()}}move(e){let t=this.at(e),{orbit:n,hold:s}=this.picture,r=this.pointers.get(e.pointerId);if(!r){e.pointerType!=="touch"&&(this.over=t),this.picture.draw();return}let[o,a]=[t.x-r.x,t.y-r.y];this.moved+=Math.hypot(o,a);let l=this.picture.ownCell().height;if(this.doing==="two"&&this.pointers.size===2){let c=[...this.pointers].find(([u])=>u!==e.pointerId)[1],h=u=>Math.max(Math.hypot(u.x-c.x,u.y-c.y),10);n.zoom(h(r)/h(t)),n.turn(o/2,a/2)}else if(this.doing==="hold"&&e.pointerId===this.holder){let c=Ho(n.camera,this.picture.ownCell(),t.x,t.y);s.follow(c,e.timeStamp)}else this.doing==="turn"?n.turn(o,a):this.doing==="pan"&&n.pan(o,a,l);this.pointers.set(e.pointerId,t),this.picture.draw()}raw(e){if(this.doing!=="hold"||e.pointerId!==this.holder)return;let t=this.at(e);this.picture.hold.follow(Ho(this.picture.orbit.camera,this.picture.ownCell(),t.x,t.y),e.timeStamp)}up(e){this.pointers.delete(e.pointerId),this.doing==="hold"&&e.pointerId===this.holder&&(this.picture.hold.release(e.timeStamp),this.holder=-1,this.doing=null),this.doing==="two"&&this.pointers.size===1&&(this.doing="turn"),this.pointers.size||(this.doing=null),delete this.picture.canvas.dataset.doing,e.pointerType!=="touch"&&(this.over=this.at(e)),this.picture.draw()}leave(){this.over=null,this.picture.hover(null),this.picture.draw()}wheel(e){e.preventDefault();let{orbit:t,hold:n}=this.picture,{height:s}=this.picture.ownCell(),r=Math.max(-3,Math.min(3,(e.deltaY||e.deltaX)/(e.deltaMode?3:100)));e.shiftKey&&this.store.settings.tool==="ball"?(n.radius=Math.min(Math.max(n.radius*.9**r,.2*.16*t.size),.8*t.size),n.action==="ball"&&n.send()):n.holds?n.depth(-r*.06*t.metres(s)*s*.5,t.axes()[2]):t.zoom(1.12**r),this.picture.draw()}double(e){let t=this.at(e),{slot:n}=this.picture.cellAt(t.x,t.y);n!==this.store.slot&&this.store.scene?.own.includes(n)?this.store.take(n):this.picture.pick(t.x,t.y,Of)||this.picture.orbit.reset(),this.picture.draw()}grabCentre(){let e=this.picture.ownCell();if(!this.picture.mayAct())return;let t=this.picture.pick(e.x+e.width/2,e.y+e.height/2,Math.max(e.width,e.height));if(!t)return;let n=this.picture.orbit.axes()[2];this.store.settings.tool==="ball"?this.picture.hold.press(t.surface,n):this.picture.hold.grab(t.point,t.place,t.place,n)}key(e){let{hold:t,orbit:n,canvas:s}=this.picture;if(!kf(e)){if(e.key==="Escape"&&t.holds){this.release(),e.preventDefault();return}if(!(document.activeElement!==s&&document.activeElement!==document.body)){if(e.key==="g"||e.key==="G")t.holds?this.release():this.grabCentre();else if(e.key in ev){let[r,o]=ev[e.key];if(t.holds){let[a,l,c]=n.axes(),h=.05*n.size;t.shift(e.shiftKey?c.multiplyScalar(o*h):a.multiplyScalar(r*h).addScaledVector(l,o*h))}else n.turn(-40*r,40*o)}else if(e.key==="+"||e.key==="=")n.zoom(1/1.15);else if(e.key==="-")n.zoom(1.15);else if(e.key==="0"||e.key==="Home")n.reset();else return;e.preventDefault(),this.picture.draw()}}}},ev={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function kf(i){let e=i.target;return i.defaultPrevented||i.ctrlKey||i.metaKey||i.altKey?!0:!!e?.closest?.("input, select, textarea, [contenteditable], dialog")}var zh=class{constructor(e,t){this.rails=e;this.connection=t;let{canvas:n}=e,s=(r,o,a)=>{r.addEventListener(o,a),this.ends.push(()=>r.removeEventListener(o,a))};s(n,"pointerdown",r=>this.down(r)),s(n,"pointermove",r=>this.move(r)),s(n,"pointerrawupdate",r=>{this.holds&&r.pointerId===this.finger&&this.follow(this.at(r).x,r.timeStamp)}),s(n,"pointerup",r=>this.up(r)),s(n,"pointercancel",r=>this.up(r)),s(n,"dblclick",r=>{let o=e.whose(this.at(r).y);o!==null&&e.take(o)}),s(window,"keydown",r=>this.key(r)),s(window,"blur",()=>this.release())}rails;connection;holds=!1;point=0;target=0;offset=0;finger=-1;pads=new co;ends=[];dispose(){this.release();for(let e of this.ends)e()}release(e){this.holds&&(this.holds=!1,this.finger=-1,this.send(e),this.rails.draw())}send(e){this.connection.point({action:this.holds?"grab":"free",point:this.point,target:[this.target,0,0],radius:0,stiffness:this.rails.stiffness,time:e})}step(e){let t=this.pads.read();return t?(t.pressed&&this.grabMiddle(),t.released&&this.release(),this.holds&&Math.abs(t.x)>.15&&this.shift(t.x*this.rails.span()*.5*e),this.pads.rumble(this.holds?this.rails.force():0),this.holds):!1}at(e){let t=this.rails.canvas.getBoundingClientRect();return{x:e.clientX-t.left,y:e.clientY-t.top}}down(e){let{x:t,y:n}=this.at(e),s=this.rails.mayAct()&&e.button===0&&this.finger<0?this.rails.reach(t,n,e.pointerType==="touch"):null;s&&(this.rails.canvas.setPointerCapture(e.pointerId),this.finger=e.pointerId,this.holds=!0,this.point=s.point,this.offset=s.near?s.place-this.rails.metres(t):0,this.follow(t,e.timeStamp))}move(e){let{x:t,y:n}=this.at(e);this.holds&&e.pointerId===this.finger?this.follow(t,e.timeStamp):this.holds||(this.rails.canvas.dataset.over=this.rails.mayAct()&&this.rails.reach(t,n,!1)?"grab":"rails")}up(e){e.pointerId===this.finger&&this.release(e.timeStamp)}follow(e,t){this.target=this.rails.metres(e)+this.offset,this.send(t),this.rails.draw()}shift(e){let t=this.rails.span();this.target=Math.min(Math.max(this.target+e,this.rails.metres(0)-t),this.rails.metres(0)+2*t),this.send(),this.rails.draw()}grabMiddle(){let e=this.rails.mayAct()&&!this.holds?this.rails.reach(NaN,NaN,!0):null;e&&(this.holds=!0,this.point=e.point,this.target=e.place,this.send(),this.rails.draw())}key(e){if(!kf(e)){if(e.key==="Escape"&&this.holds)this.release();else{if(document.activeElement!==this.rails.canvas&&document.activeElement!==document.body)return;if(e.key==="g"||e.key==="G")this.holds?this.release():this.grabMiddle();else if(this.holds&&(e.key==="ArrowLeft"||e.key==="ArrowRight"))this.shift((e.key==="ArrowLeft"?-.02:.02)*this.rails.span());else return}e.preventDefault()}}};var tv={light:{text:"#1b2330",soft:"#55606f",rail:"#d3dae4",line:"rgb(27 35 48 / 0.09)",paper:"#ffffff",dark:!1},dark:{text:"#eef1f5",soft:"#a7b0bd",rail:"#3a424f",line:"rgb(255 255 255 / 0.08)",paper:"#171b22",dark:!0}};function Xo(i,e,t,n,s){i.font=`${s.weight??400} ${s.size}px system-ui, sans-serif`,i.fillStyle=s.colour,i.textAlign=s.align??"left",i.textBaseline="middle",i.fillText(e,t,n)}function Bf(i,e,t,n,s,r){i.lineCap="round",i.lineWidth=s,i.strokeStyle=r,i.beginPath(),i.moveTo(e,n),i.lineTo(t,n),i.stroke()}function nv(i,e,t,n,s,r,o){i.save(),i.shadowColor=r.dark?"rgb(0 0 0 / 0.55)":"rgb(20 30 50 / 0.28)",i.shadowBlur=o?14:8,i.shadowOffsetY=o?4:2,i.fillStyle=r.dark?"#f3f5f8":"#ffffff",Wo(i,e,t,n),i.restore();let[a,l,c]=Gs(s),h=i.createLinearGradient(e,t-n,e,t+n);h.addColorStop(0,`rgb(${[a,l,c].map(u=>Math.round(u+(255-u)*.22)).join(" ")})`),h.addColorStop(1,s),i.fillStyle=h,Wo(i,e,t,n-2.5),i.strokeStyle="rgb(255 255 255 / 0.75)",i.lineWidth=1.5,i.lineCap="round",i.beginPath();for(let u of[-.22,0,.22])i.moveTo(e+u*n,t-.3*n),i.lineTo(e+u*n,t+.3*n);i.stroke()}function Wo(i,e,t,n){i.beginPath(),i.arc(e,t,Math.max(n,0),0,2*Math.PI),i.fill()}function iv(i,e,t,n,s,r=2){i.strokeStyle=s,i.lineWidth=r,i.beginPath(),i.arc(e,t,n,0,2*Math.PI),i.stroke()}function zf(i,e,t,n,s,r){i.beginPath(),i.moveTo(e,t-n),i.lineTo(e+n,t),i.lineTo(e,t+n),i.lineTo(e-n,t),i.closePath(),i.fillStyle=r.paper,i.fill(),i.fillStyle=Hs(s,.35),i.fill(),i.strokeStyle=s,i.lineWidth=1.75,i.lineJoin="round",i.stroke()}function sv(i,e,t,n,s){if(Math.abs(n)<5)return;let r=Math.sign(n);i.strokeStyle=i.fillStyle=s,i.lineWidth=3,i.lineCap="butt",i.beginPath(),i.moveTo(e,t),i.lineTo(e+n-7*r,t),i.stroke(),i.beginPath(),i.moveTo(e+n,t),i.lineTo(e+n-9*r,t-5),i.lineTo(e+n-9*r,t+5),i.fill()}function rv(i,e,t,n,s,r){Bf(i,e,t,n,s,r)}function ov(i,e,t,n,s,r,o,a,l,c){let h=(e+n)/2+2*r,u=(t+s)/2,d=Math.hypot(n-e,s-t)+Math.abs(r);i.strokeStyle=a,i.lineJoin="round",i.lineCap="round",i.lineWidth=1.8+1.6*o,i.setLineDash(l?[2,7]:[]),i.beginPath();let m=Math.max(4,Math.round(d/15)),g=l?24:m*10,y=l||c?0:6.5*(1-.45*o);for(let p=0;p<=g;p++){let f=p/g,v=1-f,M=v*v*e+2*v*f*h+f*f*n,b=v*v*t+2*v*f*u+f*f*s,E=2*v*(h-e)+2*f*(n-h),T=2*v*(u-t)+2*f*(s-u),x=Math.hypot(E,T)||1,w=Math.min(1,Math.max(0,(Math.min(f,v)*d-16)/14)),F=y*w*Math.sin(f*m*2*Math.PI);M+=-T/x*F,b+=E/x*F,p?i.lineTo(M,b):i.moveTo(M,b)}i.stroke(),i.setLineDash([])}var av=900,Vf=matchMedia("(prefers-reduced-motion: reduce)");function lv(i,e,t,n,s){return new Gf(i,e,t,n,s)}var Gf=class{constructor(e,t,n,s,r){this.scene=t;this.store=n;this.connection=s;this.stats=r;this.stiffness=t.stiffness,this.canvas.className="ct-canvas",this.canvas.dataset.over="rails",this.canvas.tabIndex=0,this.canvas.setAttribute("role","application"),this.canvas.setAttribute("aria-label","One slider for every user. Drag yours; G grabs, arrows move, Escape lets go."),e.append(this.canvas),this.furniture=new lo(e,n,{act:"Drag your slider and feel the others through it.",look:""}),this.furniture.legend("plain",""),this.drag=new zh(this,s);let o=new ResizeObserver(()=>this.resize());o.observe(e);let a=()=>this.draw();this.ends.push(()=>o.disconnect(),qr(a),n.on("settings",a),n.on("frame",a),n.on("state",a),n.on("slot",()=>{this.drag.release(),this.draw()}),n.on("connection",()=>{n.connection==="open"&&this.drag.holds&&this.drag.send()})),this.resize()}scene;store;connection;stats;canvas=document.createElement("canvas");stiffness;pen=this.canvas.getContext("2d");drag;furniture;ends=[];width=0;height=0;shown=null;handle=0;last=0;half=.1;wanted=.1;proxy=0;pulsed={slot:-1,since:-1/0};reset(){this.wanted=.1,this.draw()}pulse(e){this.pulsed={slot:e,since:performance.now()},this.draw()}spot(e=0){let t=this.copy(this.store.slot);return t?{x:this.x(this.place(t,e)),y:this.y(this.store.slot),point:e}:null}aim(e){let t=e-this.canvas.getBoundingClientRect().left,n=this.reach(t,this.y(this.store.slot),!0);return n&&{point:n.point,to:[this.metres(t),0,0]}}dispose(){cancelAnimationFrame(this.handle),this.handle=-1,this.drag.dispose(),this.furniture.dispose();for(let e of this.ends)e();this.canvas.remove()}reach(e,t,n){let s=this.copy(this.store.slot);if(!s)return null;let r=Number.isNaN(e);if(!r&&Math.abs(t-this.y(this.store.slot))>Math.max(this.gap*.45,n?34:24))return null;let o=0,a=1/0;for(let l=0;l<this.shown.points;l++){let c=Math.abs(this.x(this.place(s,l))-(r?this.x(this.scene.centre[0]):e));c<a&&([a,o]=[c,l])}return{point:o,place:this.place(s,o),near:a<44}}metres(e){return this.scene.centre[0]+(e-this.middle)/(this.right-this.left)*2*this.half}span(){return 2*this.half}force(){return Math.min(this.pull()/this.most,1)}mayAct(){return this.connection.mayAct}whose(e){return this.scene.users.find(({slot:t})=>Math.abs(this.y(t)-e)<this.gap/2)?.slot??null}take(e){this.scene.own.includes(e)&&this.store.take(e)}draw(){this.handle||(this.handle=requestAnimationFrame(e=>this.tick(e)))}get narrow(){return this.width<620}get left(){return this.narrow?30:168}get right(){return this.width-(this.narrow?30:104)}get middle(){return(this.left+this.right)/2}get gap(){return(this.height-this.foot-30)/this.scene.users.length}get foot(){return 108}get most(){return this.scene.stiffness*this.half}y(e){return 26+this.gap*(this.scene.users.findIndex(t=>t.slot===e)+.5)+(this.narrow?8:0)}x(e){return this.middle+(e-this.scene.centre[0])/(2*this.half)*(this.right-this.left)}copy(e){return this.shown?.copies.find(t=>t.slot===e)}place(e,t){return this.scene.points[3*t]+e.displacement[3*t]*this.shown.scale}mean(e){let t=0;for(let n=0;n<this.shown.points;n++)t+=this.place(e,n);return t/Math.max(this.shown.points,1)}pull(){let e=this.copy(this.store.slot);return this.drag.holds&&e?this.stiffness*Math.abs(this.drag.target-this.place(e,this.drag.point)):0}resize(){let e=this.canvas.parentElement?.getBoundingClientRect();if(!e||e.width<1||e.height<1)return;[this.width,this.height]=[Math.round(e.width),Math.round(e.height)];let t=devicePixelRatio||1;this.canvas.width=Math.round(this.width*t),this.canvas.height=Math.round(this.height*t),this.pen.setTransform(t,0,0,t,0,0),this.draw()}tick(e){this.handle=0;let t=Math.min((e-this.last)/1e3,.1);this.last=e;let n=this.store.frame!==null&&this.store.frame!==this.shown;this.shown=this.store.frame;let s=this.drag.step(t);s=this.range(t)||s,s=this.lag(t)||s,s=e-this.pulsed.since<av||s,this.paint(e),n&&this.stats.drew(this.shown.echo,this.shown.received,performance.now()),s&&this.draw()}range(e){if(!this.shown||this.drag.holds)return!1;let t=0;for(let n of this.shown.copies){for(let s=0;s<this.shown.points;s++)t=Math.max(t,Math.abs(this.place(n,s)-this.scene.centre[0]));n.hasHand&&n.mode!=="free"&&(t=Math.max(t,Math.abs(n.target[0]-this.scene.centre[0])))}return(t>.92*this.wanted||t<.3*this.wanted)&&(this.wanted=Math.max(ao(t*1.15),.1)),this.half+=(this.wanted-this.half)*(Vf.matches?1:1-Math.exp(-e*5)),Math.abs(this.half-this.wanted)>.001*this.wanted?!0:(this.half=this.wanted,!1)}lag(e){let t=this.copy(this.store.slot);if(!this.drag.holds||!t)return this.proxy=NaN,!1;Number.isNaN(this.proxy)&&(this.proxy=this.drag.target);let n=this.force(),s=this.place(t,this.drag.point),r=this.drag.target+(s-this.drag.target)*.6*n/(n+.45);return this.proxy+=(r-this.proxy)*(Vf.matches?1:1-Math.exp(-e*55)),Math.abs(r-this.proxy)>1e-4*this.half}paint(e){let{pen:t,store:n}=this,s=Vs(n.settings.theme),r=tv[s?"dark":"light"];t.clearRect(0,0,this.width,this.height),this.scale(r);let o=this.scene.users.map(a=>a.slot);for(let a of o)this.rail(a,r,e);this.springs(r);for(let a of o)this.beliefs(a,r);for(let a of o)this.slider(a,r);this.key(r)}scale(e){let{pen:t}=this,n=this.height-this.foot+4;for(let s=-4;s<=4;s++){let r=Math.round(this.middle+s/8*(this.right-this.left))+.5;if(t.strokeStyle=s===0?Hs(e.dark?"#ffffff":"#1b2330",.22):e.line,t.lineWidth=1,t.beginPath(),t.moveTo(r,22),t.lineTo(r,n),t.stroke(),s%2===0&&!(this.narrow&&Math.abs(s)>2)){let o=s===0?"rest":`${s>0?"+":""}${Nl(s/4*this.half,this.half/2)}`;Xo(t,o,r,n+13,{size:11.5,colour:e.soft,align:"center"})}}}key(e){let t=this.height-25,n=this.narrow?22:32;zf(this.pen,n,t,5.5,e.soft,e),Xo(this.pen,"what a user knows of a neighbour",n+13,t,{size:12,colour:e.soft})}rail(e,t,n){let{pen:s,store:r}=this,o=_i(e,t.dark),a=this.y(e),l=e===r.slot,c=this.copy(e),h=!c||r.state?.members[e]?.here===!1;l&&(s.fillStyle=Hs(o,t.dark?.13:.07),s.beginPath(),s.roundRect(8,a-this.gap*.46,this.width-16,this.gap*.92,14),s.fill());let u=(n-this.pulsed.since)/av;e===this.pulsed.slot&&u<1&&(s.strokeStyle=Hs(o,Vf.matches?.8:Math.sin(u*Math.PI*3)**2),s.lineWidth=3,s.beginPath(),s.roundRect(8,a-this.gap*.46,this.width-16,this.gap*.92,14),s.stroke()),Bf(s,this.left,this.right,a,l?7:5,t.rail);let d=this.scene.users.find(b=>b.slot===e).name,m=r.state?Ll(r.state,r.slot).get(e):void 0,g=c&&!c.direct?`, ${ss(c.age)} old`:"",y=h?"not here":e===r.me?"you":l?"":r.state?m===void 0?"out of reach":this.narrow?`+${ss(m)}`:r.me===null?`${ss(m)} after ${this.scene.users.find(b=>b.slot===r.slot)?.name}${g}`:`feels you ${ss(m)} later${g}`:"",[p,f]=this.narrow?[this.left-8,a-this.gap*.33]:[26,a-9];Xo(s,d,p,f,{size:15,weight:650,colour:h?t.soft:o});let v=this.narrow?[p+s.measureText(d).width+8,f]:[p,a+10];if(Xo(s,y,v[0],v[1],{size:12,colour:t.soft}),h)return;let M=l&&this.drag.holds?this.pull():Math.abs(c.force[0]);if(M>.005){let[b,E]=this.narrow?[this.right+8,f]:[this.width-26,a];Xo(s,Dl(M),b,E,{size:13,weight:600,colour:t.text,align:"right"})}}springs(e){let{state:t}=this.store;if(!t||!this.shown)return;let n=s=>this.scene.users.findIndex(r=>r.slot===s);for(let[s,r]of t.links){let[o,a]=[this.copy(s),this.copy(r)];if(!o||!a)continue;let[l,c]=[this.mean(o),this.mean(a)],h=!!t.emulated[`${s}-${r}`]?.cut||!!t.emulated[`${r}-${s}`]?.cut,u=t.ends[`${s}-${r}`],d=h||u&&u.state!=="coupled"&&u.state!=="ready"&&u.state!=="guarded",m=Math.min(Math.abs(l-c)/(.6*this.half),1),g=Math.abs(n(s)-n(r)),y=g<2?0:(g-1)*Math.min(this.gap*.42,38)*((n(s)+n(r))%2?1:-1),p=d?Hs(e.dark?"#a7b0bd":"#55606f",.55):pa(m,e.dark);ov(this.pen,this.x(l),this.y(s),this.x(c),this.y(r),y,m,p,!!d,!1)}}beliefs(e,t){let{state:n,history:s}=this.store;if(!(!n||!this.copy(e)))for(let[r,o]of n.links){if(r!==e&&o!==e)continue;let a=r===e?o:r,l=gd(n,e,a);if(l===null||!this.copy(a))continue;let c=s.before(a,l);if(Number.isNaN(c))continue;let h=0;for(let u=0;u<this.shown.points;u++)h+=this.scene.points[3*u]/this.shown.points;zf(this.pen,this.x(h+c),this.y(e),6,_i(a,t.dark),t)}}slider(e,t){let n=this.copy(e);if(!n)return;let{pen:s}=this,r=_i(e,t.dark),o=this.y(e),a=e===this.store.slot,l=a&&this.drag.holds,c=Math.min(a?19:15,this.gap*.3),h=l?this.drag.point:Math.max(n.node,0),u=l||n.hasHand&&n.mode!=="free"&&n.node>=0,d=this.x(this.place(n,Math.min(h,this.shown.points-1))),m=l?Math.sign(this.drag.target-this.place(n,h))*this.pull():n.force[0];if(u){let y=Math.min(Math.abs(m)/this.most,1),p=this.x(l?this.drag.target:n.target[0]);rv(s,d,p,o,3+4*y,pa(y,t.dark)),l?(s.fillStyle=r,Wo(s,this.x(this.proxy),o,7),iv(s,p,o,12,r,2.5)):(s.fillStyle=r,Wo(s,p,o,5))}if(this.shown.points>1)for(let y=0;y<this.shown.points;y++)s.fillStyle=Hs(r,.85),Wo(s,this.x(this.place(n,y)),o,Math.min(c*.5,8));let g=this.shown.points>1&&u?d:this.x(this.mean(n));nv(s,g,o,c,r,t,a),u&&sv(s,g,o-c-8,m/this.most*(this.right-this.left)*.3,r)}};var cv=[2,1,.75,.55,.4],Vh=class{constructor(e){this.finest=e;this.level=e()>1?0:1}finest;level;drawn=0;missed=0;kept=0;wait=240;get ratio(){return Math.min(this.finest(),cv[this.level])}get shadows(){return this.level>2?3:1}took(e,t){let n=this.ratio;this.drawn++;let s=t>.021?Math.min(e,6):0;return this.missed+=s,this.kept=s?0:this.kept+1,this.drawn>=24&&(this.missed>.06*(this.drawn+this.missed)&&this.level<cv.length-1&&(this.level++,this.kept=0,this.wait=Math.min(2*this.wait,15360)),this.drawn=this.missed=0),this.kept>this.wait&&this.level>0&&this.ratio<this.finest()&&(this.level--,this.kept=this.drawn=this.missed=0),this.ratio!==n}},AT=null;function Ai(){return AT??=CT()}function CT(){let i=document.createElement("canvas").getContext("webgl2"),e=i?.getExtension("WEBGL_debug_renderer_info"),t=i&&e?String(i.getParameter(e.UNMASKED_RENDERER_WEBGL)):"";return i?.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|software/i.test(t)}function qo(){return Ai()?{LEAN:""}:{}}var Za=`
#ifdef LEAN
vec3 toLinear(vec3 c) { return c * c; }
vec3 toScreen(vec3 c) { return sqrt(c); }
float gleam(float x) { x *= x; x *= x; x *= x; x *= x; return x * x; }
float edge(float x) { return x * x * x; }
#else
vec3 toLinear(vec3 c) { return pow(c, vec3(2.2)); }
vec3 toScreen(vec3 c) { return pow(c, vec3(1.0 / 2.2)); }
float gleam(float x) { return pow(x, 42.0); }
float edge(float x) { return pow(x, 3.5); }
#endif
vec3 lit(vec3 colour, vec3 n, vec3 eye, float gloss) {
  vec3 key = normalize(vec3(-0.45, 0.8, 0.55)), fill = normalize(vec3(0.9, 0.05, 0.35));
  float up = 0.5 + 0.5 * n.y;
  float wrap = max(dot(n, key) * 0.85 + 0.15, 0.0);
  vec3 light = mix(vec3(0.30, 0.29, 0.33), vec3(0.60, 0.62, 0.66), up) + 0.78 * wrap * vec3(1.0, 0.98, 0.94)
    + 0.16 * max(dot(n, fill), 0.0) * vec3(0.8, 0.9, 1.0);
  vec3 halfway = normalize(key + eye);
  float shine = gleam(max(dot(n, halfway), 0.0)) * gloss;
  float rim = edge(1.0 - max(dot(n, eye), 0.0));
  return toScreen(toLinear(colour) * light + shine + rim * 0.10 * vec3(0.8, 0.9, 1.0));
}
`,Gh=`
uniform vec3 stops[9];
vec3 ramp(float value) {
  float at = clamp(value, 0.0, 1.0) * 8.0;
  int low = min(int(at), 7);
  return mix(stops[low], stops[low + 1], at - float(low));
}
`,hv={vertex:`
    ${Za}${Gh}
    attribute vec3 shift;
    attribute float value;
    uniform float scale, full, flash;
    uniform vec3 plain;
    uniform int by;
    #ifdef LEAN
    varying vec3 shown;
    #else
    varying vec3 n, p;
    varying float v;
    #endif
    void main() {
      vec4 q = modelViewMatrix * vec4(position + shift * scale, 1.0);
      float far = (by == 0 ? length(shift) * scale : value) / full;
      gl_Position = projectionMatrix * q;
      #ifdef LEAN
      vec3 eye = normalize(-q.xyz), m = normalize(mat3(modelViewMatrix) * normal + 1e-20);
      if (dot(m, eye) < -0.2) m = -m;
      shown = mix(lit(by == 2 ? plain : ramp(far), m, eye, 0.20), vec3(1.0), flash * 0.5);
      #else
      n = mat3(modelViewMatrix) * normal;
      p = q.xyz;
      v = far;
      #endif
    }`,fragment:`
    #ifdef LEAN
    varying vec3 shown;
    void main() { gl_FragColor = vec4(shown, 1.0); }
    #else
    ${Za}${Gh}
    uniform vec3 plain;
    uniform int by;
    uniform float flash;
    varying vec3 n, p;
    varying float v;
    void main() {
      vec3 eye = normalize(-p), m = normalize(n);
      if (!gl_FrontFacing) m = -m;
      vec3 colour = by == 2 ? plain : ramp(v);
      gl_FragColor = vec4(mix(lit(colour, m, eye, 0.20), vec3(1.0), flash * 0.5), 1.0);
    }
    #endif`},uv={vertex:`
    attribute vec3 shift, own;
    uniform float scale, apart, flash, strength;
    #ifndef LEAN
    varying vec3 n, p;
    #endif
    varying float v;
    void main() {
      vec4 q = modelViewMatrix * vec4(position + shift * scale, 1.0);
      // Where both surfaces cross they differ along neither's normal: no seam is seen.
      vec3 differs = (shift - own) * scale / apart;
      v = max(smoothstep(0.1, 1.0, dot(differs, normalize(normal + 1e-20))), 0.5 * smoothstep(3.0, 8.0, length(differs)));
      gl_Position = projectionMatrix * q;
      #ifdef LEAN
      float rim = 1.0 - abs(dot(normalize(mat3(modelViewMatrix) * normal + 1e-20), normalize(-q.xyz)));
      v = min(v * strength * (0.05 + 0.95 * rim * sqrt(rim)) + flash * 0.35, 1.0);
      #else
      n = mat3(modelViewMatrix) * normal;
      p = q.xyz;
      #endif
    }`,fragment:`
    uniform vec3 colour;
    uniform float flash, strength;
    varying float v;
    #ifdef LEAN
    void main() { gl_FragColor = vec4(mix(colour, vec3(1.0), flash * 0.3), v); }
    #else
    varying vec3 n, p;
    void main() {
      float rim = 1.0 - abs(dot(normalize(n), normalize(-p)));
      float cover = v * strength * (0.05 + 0.95 * pow(rim, 1.5)) + flash * 0.35;
      gl_FragColor = vec4(mix(colour, vec3(1.0), flash * 0.3), min(cover, 1.0));
    }
    #endif`},Hh={vertex:`
    attribute vec3 shift;
    attribute float value;
    uniform float scale, full, size, height;
    uniform int by;
    varying float v;
    void main() {
      vec4 q = modelViewMatrix * vec4(position + shift * scale, 1.0);
      v = (by == 0 ? length(shift) * scale : value) / full;
      gl_Position = projectionMatrix * q;
      gl_PointSize = max(size * projectionMatrix[1][1] * height / gl_Position.w, 3.0);
    }`,fragment:`
    ${Za}${Gh}
    uniform vec3 plain;
    uniform int by;
    uniform float opacity, flash;
    varying float v;
    void main() {
      vec2 c = vec2(2.0, -2.0) * (gl_PointCoord - 0.5);
      float r = dot(c, c);
      if (r > 1.0) discard;
      vec3 colour = by == 2 ? plain : ramp(v);
      gl_FragColor = vec4(mix(lit(colour, vec3(c, sqrt(1.0 - r)), vec3(0, 0, 1), 0.25), vec3(1.0), flash * 0.5), opacity);
    }`},Hf={vertex:Hh.vertex.replace(/gl_PointSize.*\n/,`
`),fragment:`
    ${Gh}
    uniform vec3 plain;
    uniform int by;
    uniform float opacity;
    varying float v;
    void main() { gl_FragColor = vec4((by == 2 ? plain : ramp(v)) * 0.85, opacity); }`},Wf={vertex:`
    ${Za}
    uniform vec3 colour;
    #ifdef LEAN
    varying vec3 shown;
    #else
    varying vec3 n, p;
    #endif
    void main() {
      vec4 q = modelViewMatrix * vec4(position, 1.0);
      #ifdef LEAN
      shown = lit(colour, normalize(normalMatrix * normal), normalize(-q.xyz), 0.35);
      #else
      n = normalMatrix * normal;
      p = q.xyz;
      #endif
      gl_Position = projectionMatrix * q;
    }`,fragment:`
    uniform float opacity;
    #ifdef LEAN
    varying vec3 shown;
    void main() { gl_FragColor = vec4(shown, opacity); }
    #else
    ${Za}
    uniform vec3 colour;
    varying vec3 n, p;
    void main() { gl_FragColor = vec4(lit(colour, normalize(n), normalize(-p), 0.35), opacity); }
    #endif`},Xf={vertex:`
    attribute vec3 shift;
    uniform float scale, ground, reach;
    varying float height;
    void main() {
      vec4 q = modelMatrix * vec4(position + shift * scale, 1.0);
      height = (q.z - ground) / reach;
      gl_Position = projectionMatrix * viewMatrix * q;
    }`,fragment:`
    varying float height;
    void main() { gl_FragColor = vec4(1.0, clamp(height, 0.0, 1.0), 0.0, 1.0); }`},qf={vertex:`
    varying vec2 at;
    void main() {
      vec4 q = modelMatrix * vec4(position, 1.0);
      at = q.xy;
      gl_Position = projectionMatrix * viewMatrix * q;
    }`,fragment:`
    uniform sampler2D shadow;
    uniform vec2 centre;
    uniform vec3 line, dark;
    uniform float reach, pitch, strength, opacity, plate;
    varying vec2 at;
    float lines(vec2 q) {
      vec2 width = max(fwidth(q), 1e-6);
      vec2 l = clamp(1.15 - abs(fract(q - 0.5) - 0.5) / width, 0.0, 1.0) * clamp(0.5 / width - 1.0, 0.0, 1.0);
      return max(l.x, l.y);
    }
    void main() {
      vec2 d = (at - centre) / reach;
      float away = length(d), cover = 0.0, fade = smoothstep(2.1, 0.3, away);
      vec2 q = (at - centre) / pitch;
      if (away > 2.1) discard;
      #ifdef LEAN
      if (away < 1.1) {
        vec4 seen = textureLod(shadow, vec2(0.5 + 0.5 * d.x, 0.5 - 0.5 * d.y), 2.5);
        if (seen.r > 0.003) cover = strength * seen.r * (1.0 - 0.75 * min(seen.g / seen.r, 1.0));
      }
      #else
      if (away < 1.3) {
        vec2 uv = vec2(0.5 + 0.5 * d.x, 0.5 - 0.5 * d.y);
        vec4 far = textureLod(shadow, uv, 4.6);
        if (far.r > 0.003) {
          float h = far.g / far.r;
          float soft = mix(mix(textureLod(shadow, uv, 2.5).r, textureLod(shadow, uv, 3.5).r, smoothstep(0.0, 0.2, h)), far.r, smoothstep(0.15, 0.6, h));
          cover = strength * soft * (1.0 - 0.75 * smoothstep(0.0, 1.0, h));
        }
      }
      #endif
      float grid = max(opacity * max(lines(q), 0.55 * lines(q * 5.0)), plate) * fade;
      float all = cover + grid * (1.0 - cover);
      gl_FragColor = vec4(mix(line, dark, cover / max(all, 1e-4)), all);
    }`};var RT=Math.cos(50*Math.PI/180),Wh=class{constructor(e){this.scene=e;let t=e.points.length/3;if(e.skin){let s=IT(e.points,e.skin.triangles);this.point=s.point,this.triangles=s.triangles}else this.point=Uint32Array.from({length:t},(s,r)=>r),this.triangles=null;this.corners=this.point.length,this.rest=new Float32Array(this.corners*3),this.corner=new Uint32Array(t),this.point.forEach((s,r)=>{this.corner[s]=r;for(let o=0;o<3;o++)this.rest[3*r+o]=e.points[3*s+o]}),this.sides=e.skin?PT(e.skin.triangles,this.corner,t):e.edges??new Uint32Array;let n=this.sides.length/2;this.restLengths=new Float32Array(n),this.degree=new Float32Array(this.corners);for(let s=0;s<n;s++){let r=this.sides[2*s],o=this.sides[2*s+1];this.restLengths[s]=dv(this.rest,r,o),this.degree[r]++,this.degree[o]++}for(let s=0;s<this.corners;s++)this.degree[s]=Math.max(this.degree[s],1)}scene;point;rest;triangles;sides;corner;restLengths;degree;corners},Xh=class{constructor(e){this.shape=e;let t=e.corners,n=(r,o)=>new Vn(r,o).setUsage(Ph);this.places=e.rest.slice(),this.seen=new Uint8Array(t),this.shift=n(new Int16Array(3*t),3),this.normal=n(new Float32Array(3*t),3),this.value=n(new Float32Array(t),1);let s=new Vn(e.rest,3);for(let r of[this.geometry,...e.triangles?[]:[this.lines=new In]])r.setAttribute("position",s),r.setAttribute("shift",this.shift),r.setAttribute("value",this.value);if(e.triangles){this.geometry.setAttribute("normal",this.normal),this.geometry.setIndex(new Vn(e.triangles,1)),this.film=new In;for(let r of["position","shift","normal"])this.film.setAttribute(r,this.geometry.getAttribute(r));this.film.setIndex(this.faces=new Vn(new Uint32Array(e.triangles.length),1).setUsage(Ph))}this.lines?.setIndex(new Vn(e.sides,1)),this.update(new Int16Array(e.scene.points.length),0,!1)}shape;geometry=new In;lines=null;film=null;shift;places;mean=[0,0,0];peak=0;normal;value;faces=null;seen;update(e,t,n){let{point:s,rest:r,corners:o}=this.shape,a=this.shift.array,l=this.places,c=0,h=0,u=0,d=0;for(let m=0;m<o;m++){let g=3*m,y=3*s[m],p=e[y],f=e[y+1],v=e[y+2];a[g]=p,a[g+1]=f,a[g+2]=v,l[g]=r[g]+p*t,l[g+1]=r[g+1]+f*t,l[g+2]=r[g+2]+v*t,h+=p,u+=f,d+=v,c=Math.max(c,p*p+f*f+v*v)}this.mean[0]=h*t/o,this.mean[1]=u*t/o,this.mean[2]=d*t/o,this.shift.needsUpdate=!0,this.peak=n?this.stretch():Math.sqrt(c)*t,this.shape.triangles&&this.normals(this.shape.triangles)}colour(e){let t=this.value.array;this.shape.point.forEach((n,s)=>t[s]=e[n]),this.value.needsUpdate=!0}differs(e,t,n,s){let{triangles:r,corners:o}=this.shape;if(!r||!this.film||!this.faces)return!0;let{places:a,seen:l}=this,c=e.places,h=this.normal.array,[u,d]=[(.1*n)**2,(3*n)**2];for(let y=0;y<o;y++){let p=3*y,f=h[p],v=h[p+1],M=h[p+2],b=s;if(!b){let T=a[p]-c[p],x=a[p+1]-c[p+1],w=a[p+2]-c[p+2],F=T*f+x*v+w*M;b=F>0&&F*F>u*(f*f+v*v+M*M)||T*T+x*x+w*w>d}let E=f*(a[p]-t.x)+v*(a[p+1]-t.y)+M*(a[p+2]-t.z)<0;l[y]=(b?1:0)|(E?2:0)}let m=this.faces.array,g=0;for(let y=0;y<r.length;y+=3){let p=r[y],f=r[y+1],v=r[y+2];(l[p]|l[f]|l[v])===3&&(m[g++]=p,m[g++]=f,m[g++]=v)}return this.film.setDrawRange(0,g),this.faces.clearUpdateRanges(),this.faces.addUpdateRange(0,g),g&&(this.faces.needsUpdate=!0),g>0}dispose(){this.film?.dispose(),this.geometry.dispose(),this.lines?.dispose()}normals(e){let t=this.places,n=this.normal.array;n.fill(0);for(let s=0;s<e.length;s+=3){let r=3*e[s],o=3*e[s+1],a=3*e[s+2],l=t[o]-t[r],c=t[o+1]-t[r+1],h=t[o+2]-t[r+2],u=t[a]-t[r],d=t[a+1]-t[r+1],m=t[a+2]-t[r+2],g=c*m-h*d,y=h*u-l*m,p=l*d-c*u;n[r]+=g,n[r+1]+=y,n[r+2]+=p,n[o]+=g,n[o+1]+=y,n[o+2]+=p,n[a]+=g,n[a+1]+=y,n[a+2]+=p}this.normal.needsUpdate=!0}stretch(){let{sides:e,restLengths:t,degree:n,corner:s,point:r,corners:o}=this.shape,a=this.value.array;a.fill(0);for(let c=0;c<t.length;c++){let h=e[2*c],u=e[2*c+1],d=Math.abs(dv(this.places,h,u)/Math.max(t[c],1e-12)-1);a[h]+=d/n[h],a[u]+=d/n[u]}let l=0;for(let c=0;c<o;c++)a[c]=a[s[r[c]]],l=Math.max(l,a[c]);return this.value.needsUpdate=!0,l}};function dv(i,e,t){let n=i[3*e]-i[3*t],s=i[3*e+1]-i[3*t+1],r=i[3*e+2]-i[3*t+2];return Math.sqrt(n*n+s*s+r*r)}function PT(i,e,t){let n=new Set,s=[];for(let r=0;r<i.length;r++){let o=i[r],a=i[r%3===2?r-2:r+1],l=Math.min(o,a)*t+Math.max(o,a);n.has(l)||(n.add(l),s.push(e[o],e[a]))}return Uint32Array.from(s)}function IT(i,e){let t=e.length/3,n=new Float32Array(3*t),s=Array.from({length:i.length/3},()=>[]);for(let c=0;c<t;c++){let[h,u,d]=[0,1,2].map(f=>3*e[3*c+f]),m=[0,1,2].map(f=>i[u+f]-i[h+f]),g=[0,1,2].map(f=>i[d+f]-i[h+f]),y=[m[1]*g[2]-m[2]*g[1],m[2]*g[0]-m[0]*g[2],m[0]*g[1]-m[1]*g[0]],p=Math.hypot(...y)||1;for(let f=0;f<3;f++)n[3*c+f]=y[f]/p,s[e[3*c+f]].push(c)}let r=(c,h)=>n[3*c]*n[3*h]+n[3*c+1]*n[3*h+1]+n[3*c+2]*n[3*h+2]>RT,o=(c,h,u)=>{for(let d=0;d<3;d++)for(let m=0;m<3;m++)if(e[3*c+d]===e[3*h+m]&&e[3*c+d]!==u)return!0;return!1},a=[],l=new Uint32Array(e.length);return s.forEach((c,h)=>{let u=new Set(c);for(let d of c){if(!u.delete(d))continue;let m=[d];for(let g=0;g<m.length;g++)for(let y of u)r(m[g],y)&&o(m[g],y,h)&&(u.delete(y),m.push(y));for(let g of m)for(let y=0;y<3;y++)e[3*g+y]===h&&(l[3*g+y]=a.length);a.push(h)}c.length||a.push(h)}),{point:Uint32Array.from(a),triangles:l}}var LT=il.map(i=>new V(...Gs(i)).divideScalar(255)),qh=class{scale={value:0};full={value:1};by={value:0};stops={value:LT};apart;size;height={value:1};constructor(e,t){this.apart={value:.05*e};let n=t.restLengths,s=n.length?n.reduce((r,o)=>r+o,0)/n.length:e;this.size={value:Math.min(.17*s,.08*e)}}},$h=class{constructor(e,t,n){this.slot=e;this.moving=new Xh(t);let{geometry:s,lines:r,film:o}=this.moving,a={...n,plain:this.plain,flash:this.flash},l=(c,h,u)=>{let d=new Un({defines:qo(),vertexShader:c.vertex,fragmentShader:c.fragment,uniforms:{...a,...h},transparent:u,depthWrite:!u,side:u?0:2});return this.made.push(d),d};if(t.triangles)this.body.add(new Kt(s,l(hv,{},!1))),this.shell.add(new Kt(o,l(uv,{colour:this.colour,strength:this.strength},!0)));else{let c={plain:this.colour,by:{value:2}};this.body.add(new Io(s,l(Hh,{opacity:{value:1}},!1))),this.body.add(new rr(r,l(Hf,{opacity:{value:1}},!1))),this.shell.add(new Io(s,l(Hh,{opacity:{value:.35},...c},!0))),this.shell.add(new rr(r,l(Hf,{opacity:{value:.35},...c},!0)))}for(let c of[...this.body.children,...this.shell.children])c.frustumCulled=!1;this.group.add(this.body,this.shell)}slot;moving;group=new Qn;body=new Qn;shell=new Qn;made=[];plain={value:new V};colour={value:new V};flash={value:0};strength={value:1};against(e){this.moving.film?.setAttribute("own",e.shift)}paint(e,t){let[n,s,r]=Gs(e).map(o=>o/255);this.colour.value.set(n,s,r),this.plain.value.set(.9,.895,.875).lerp(this.colour.value,.22).multiplyScalar(t?.9:1),this.strength.value=t?1:.95}show(e,t){this.body.visible=e==="solid",this.shell.visible=e==="ghost",this.flash.value=t}thin(e,t,n){this.shell.visible&&(this.shell.visible=this.moving.differs(e,t,n,this.flash.value>0))}order(e){let[t,n,s]=this.moving.mean,r=e.x*t+e.y*n+e.z*s;for(let o of this.shell.children)o.renderOrder=10-r/(Math.abs(r)+1)}dispose(){this.moving.dispose();for(let e of this.made)e.dispose()}};var fv=Ai()?128:256,Yh=class{mesh;target=new ei(fv,fv,{minFilter:Bi,magFilter:Dn,generateMipmaps:!0,depthBuffer:!0});scene=new Cr;camera;cast=null;shade;constructor(e,t,n,s,r){let o=r??t-.1*n,a=2*n;this.mesh=new Kt(new Rs(9*n,9*n),new Un({defines:qo(),vertexShader:qf.vertex,fragmentShader:qf.fragment,transparent:!0,depthWrite:!1,uniforms:{shadow:{value:this.target.texture},centre:{value:new _t(e.x,e.y)},line:{value:new V},dark:{value:new V},reach:{value:a},pitch:{value:ao(n*.9)},strength:{value:.3},opacity:{value:.5},plate:{value:r===null?0:.16}}})),this.mesh.position.set(e.x,e.y,o),this.mesh.renderOrder=-1,this.camera=new Do(-a,a,a,-a,0,12*n),this.camera.up.set(0,-1,0),this.camera.position.set(e.x,e.y,o-n),this.camera.lookAt(e.x,e.y,o),this.shade=new Un({vertexShader:Xf.vertex,fragmentShader:Xf.fragment,side:2,uniforms:{scale:{value:0},ground:{value:o},reach:{value:1.6*n}}}),s&&(this.cast=new Kt(s.geometry,this.shade),this.cast.frustumCulled=!1,this.scene.add(this.cast))}colours(e){let{line:t,dark:n,strength:s,opacity:r}=this.mesh.material.uniforms;e?t.value.set(.62,.68,.78):t.value.set(.36,.42,.52),e?n.value.set(0,0,.01):n.value.set(.1,.12,.2),s.value=e?.62:.34,r.value=e?.2:.26}shadow(e,t,n){this.cast&&(this.cast.geometry=t.geometry,this.shade.uniforms.scale.value=n,e.setRenderTarget(this.target),e.clear(),e.render(this.scene,this.camera),e.setRenderTarget(null))}dispose(){this.target.dispose(),this.mesh.geometry.dispose(),this.mesh.material.dispose(),this.shade.dispose()}};var Jh=class{constructor(e,t,n,s){this.connection=e;this.size=t;this.stiffness=n;this.flat=s;this.radius=.16*t}connection;size;stiffness;flat;action="free";point=-1;target=new V;radius;plane=new mi;offset=new V;pressed=0;get holds(){return this.action!=="free"}grab(e,t,n,s,r){this.action="grab",this.point=e,this.plane.setFromNormalAndCoplanarPoint(s,n),this.offset.subVectors(t,n),this.target.copy(t),this.send(r)}press(e,t,n){this.action="ball",this.point=-1,this.pressed=0,this.offset.copy(t).multiplyScalar(-this.radius),this.target.copy(e).add(this.offset),this.plane.setFromNormalAndCoplanarPoint(t,e),this.send(n)}push(e,t){if(this.action!=="ball"||this.pressed>=1)return!1;let n=Math.min(e/.35,1-this.pressed);return this.pressed+=n,this.shift(t.clone().multiplyScalar(n*this.radius)),!0}follow(e,t){let n=e.intersectPlane(this.plane,new V);!n||!this.holds||(this.target.copy(n).add(this.offset),this.limit(),this.send(t))}depth(e,t){this.holds&&!this.flat&&this.shift(t.clone().multiplyScalar(e))}shift(e){this.holds&&(this.offset.add(e),this.target.add(e),this.limit(),this.send())}release(e){this.holds&&(this.action="free",this.point=-1,this.send(e))}send(e){this.connection.point({action:this.action,point:Math.max(this.point,0),target:this.target.toArray(),radius:this.action==="ball"?this.radius:0,stiffness:this.stiffness,time:e})}limit(){this.flat&&(this.target.z=0);let e=this.target.length();e>50*this.size&&this.target.multiplyScalar(50*this.size/e)}};var Ka=class i{element=document.createElement("div");taken=[];made=new Map;used=new Set;since=0;count=!0;constructor(e){this.element.className="ct-labels",this.element.setAttribute("aria-hidden","true"),e.append(this.element)}static wide(e,t){return 7.1*(e.length+t.length)+52}put(e,t,n,s,r,o,a){let l=this.made.get(e)??this.make(e);this.used.add(e);let c=`ct-label ct-${t}`;l.element.className!==c&&(l.element.className=c),l.slot!==n&&l.element.style.setProperty("--user",`var(--user-${(l.slot=n)%8})`),l.text.textContent!==s&&(l.text.textContent=s);let h=l.detail.textContent;h!==r&&(this.count||!h||!r)&&(l.detail.textContent=r),t==="hand"&&(a=this.clear(o,a,i.wide(s,r)));let u=`translate(${o.toFixed(1)}px, ${a.toFixed(1)}px)`;l.place!==u&&(l.element.style.transform=l.place=u)}make(e){let t=document.createElement("div"),[n,s]=[document.createElement("b"),document.createElement("span")];t.append(n,s),this.element.append(t);let r={element:t,text:n,detail:s,slot:-1,place:""};return this.made.set(e,r),r}clear(e,t,n){for(let s=0;s<6;s++){let r=this.taken.find(o=>e<o.x+o.wide&&o.x<e+n&&Math.abs(t-o.y)<24);if(!r)break;t=r.y-24}return this.taken.push({x:e,y:t,wide:n}),t}sweep(){this.taken.length=0;for(let[t,n]of this.made)this.used.has(t)||(n.element.remove(),this.made.delete(t));this.used.clear();let e=performance.now();this.count=e-this.since>=125,this.count&&(this.since=e)}};function pv(i,e,t,n){if(!n||i.length<2)return[{slot:i[0]??0,x:0,y:0,width:e,height:t}];let s=e>=t,r=i.length-1,o=r===1?.5:.48,a=s?{slot:i[0],x:0,y:0,width:Math.round(e*o)-6/2,height:t}:{slot:i[0],x:0,y:0,width:e,height:Math.round(t*o)-6/2},[l,c]=s?[a.width+6,0]:[0,a.height+6],[h,u]=[e-l,t-c],d=1,m=0;for(let f=1;f<=r;f++){let v=Math.min(h/f,u/Math.ceil(r/f));v>m&&([m,d]=[v,f])}let g=Math.ceil(r/d),[y,p]=[(h-6*(d-1))/d,(u-6*(g-1))/g];return[a,...i.slice(1).map((f,v)=>({slot:f,x:Math.round(l+v%d*(y+6)),y:Math.round(c+Math.floor(v/d)*(p+6)),width:Math.round(y),height:Math.round(p)}))]}var $f=1.54,NT=1.15,Kh=class{constructor(e,t,n,s,r=[1.2,1.42]){this.size=t;this.cloud=n;this.room=r;this.camera.up.set(0,0,1),this.camera.near=t*.02,this.camera.far=t*60,this.home={target:e.clone(),yaw:s?-Math.PI/2:-1.08,pitch:s?$f:.36,zoom:1},this.goal=Zh(this.home),this.now=Zh(this.home)}size;cloud;room;camera=new jn(30,1,.01,100);home;goal;now;fit=1;fits=new Map;aspect(e,t){this.camera.aspect=e/Math.max(t,1),this.fit=this.fitted(this.camera.aspect),this.camera.updateProjectionMatrix(),this.apply()}fitted(e){let t=e.toFixed(3),n=this.fits.get(t);if(n)return n;let{target:s}=this.home,r=Yf(this.home),o=new V(0,0,1).cross(r).normalize(),a=r.clone().cross(o),l=new V,c=Math.tan(this.camera.fov*Math.PI/360),h=3*Math.max(1,Math.floor(this.cloud.length/3/500)),u=.5*this.size;for(let d=0;d<this.cloud.length;d+=h)l.fromArray(this.cloud,d).sub(s),u=Math.max(u,l.dot(r)+this.room[e<1?0:1]*Math.max(Math.abs(l.dot(o))/e,1.12*Math.abs(l.dot(a)))/c);return this.fits.set(t,u),u}turn(e,t){this.goal.yaw-=e*.0065,this.goal.pitch=Math.min(Math.max(this.goal.pitch+t*.0065,-$f),$f)}zoom(e){let t=this.nearest(this.goal)/this.fit;this.goal.zoom=Math.min(Math.max(Math.max(this.goal.zoom,t)*e,t,.12),Math.max(6,t))}pan(e,t,n){let s=this.metres(n),[r,o]=this.axes();this.goal.target.addScaledVector(r,-e*s).addScaledVector(o,t*s)}reset(){this.goal=Zh(this.home)}metres(e){return 2*Math.tan(this.camera.fov*Math.PI/360)*Math.max(this.now.zoom*this.fit,this.nearest(this.now))/Math.max(e,1)}axes(){let e=new V,t=new V,n=new V;return this.camera.updateMatrixWorld(),this.camera.matrixWorld.extractBasis(e,t,n),[e,t,n.negate()]}step(e){let{now:t,goal:n}=this,s=Math.abs(n.yaw-t.yaw)+Math.abs(n.pitch-t.pitch)+Math.abs(Math.log(n.zoom/t.zoom))+n.target.distanceTo(t.target)/this.size;if(s===0)return!1;let r=s<.001?1:e;return r<1?(t.yaw+=(n.yaw-t.yaw)*r,t.pitch+=(n.pitch-t.pitch)*r,t.zoom*=(n.zoom/t.zoom)**r,t.target.lerp(n.target,r)):this.now=Zh(n),this.apply(),!0}nearest(e){let t=e.target.clone().sub(this.home.target),n=t.dot(Yf(e)),s=(NT*this.size)**2-t.lengthSq()+n**2;return s>0?Math.sqrt(s)-n:0}apply(){let{target:e,zoom:t}=this.now,n=Math.max(t*this.fit,this.nearest(this.now));this.camera.position.copy(Yf(this.now)).multiplyScalar(n).add(e),this.camera.lookAt(e),this.camera.updateMatrixWorld()}};function Yf({yaw:i,pitch:e}){return new V(Math.cos(i)*Math.cos(e),Math.sin(i)*Math.cos(e),Math.sin(e))}function Zh(i){return{...i,target:i.target.clone()}}var DT=new Ps(1,28,18),Jf=Ai()?new Ps(1,10,7):new Ps(1,18,12),Zf=new Lo(1,1,1,Ai()?6:12,1,!0).translate(0,.5,0),UT=new Na(1,1,Ai()?10:18).translate(0,.5,0),FT=Ai()?new No(1,.13,5,20):new No(1,.13,8,36),OT=new V(0,1,0),$o=new V,kT=new Gn;function Ns(i,e=1){let t=new Un({defines:qo(),vertexShader:Wf.vertex,fragmentShader:Wf.fragment,uniforms:{colour:{value:new V},opacity:{value:e}},transparent:e<1,depthWrite:e>=1});return Ds(t,i),t}function Ds(i,e){let[t,n,s]=Gs(e);i.uniforms.colour.value.set(t/255,n/255,s/255)}function jh(i,e,t,n){$o.subVectors(t,e);let s=$o.length();i.visible=s>1e-9,i.visible&&(i.position.copy(e),i.quaternion.copy(kT.setFromUnitVectors(OT,$o.divideScalar(s))),i.scale.set(n,s,n))}var Qh=class{constructor(e,t,n,s={least:.08,longest:.8}){this.size=e;this.full=t;this.arrow=s;this.skin=Ns(n),this.cord=Ns(n),this.glass=Ns(n,.55);for(let o of[this.skin,this.cord,this.glass]){let a=Ns(n,.2);a.depthFunc=To,a.uniforms.colour=o.uniforms.colour,this.hidden.set(o,a)}let r=(o,a)=>{let l=new Kt(o,a);if(l.frustumCulled=!1,this.group.add(l),Ai())return l;let c=new Kt(o,this.hidden.get(a));return c.frustumCulled=!1,c.renderOrder=20,l.add(c),l};this.proxy=r(Jf,this.skin),this.knot=r(Jf,this.skin),this.rope=r(Zf,this.cord),this.lead=r(Zf,this.cord),this.shaft=r(Zf,this.skin),this.head=r(UT,this.skin),this.mark=r(FT,this.skin),this.group.visible=!1}size;full;arrow;group=new Qn;spot=new V;force=0;skin;cord;glass;hidden=new Map;proxy;knot;rope;lead;shaft;head;mark;tip=new V;neck=new V;paint(e){Ds(this.skin,e),Ds(this.glass,e)}pose(e,t){let{size:n}=this,s=this.force=e.force.length();this.spot.copy(e.proxy);let r=Math.min(s/this.full,1),o=n*(.006+.012*r);if(Ds(this.cord,pa(r,!1)),this.proxy.material=e.radius>0?this.glass:this.skin,this.proxy.geometry=e.radius>0?DT:Jf,this.proxy.position.copy(e.proxy),this.proxy.scale.setScalar(e.radius>0?e.radius:n*.042),this.knot.visible=e.radius===0,this.knot.position.copy(e.place),this.knot.scale.setScalar(n*.026),jh(this.rope,e.place,e.proxy,o),jh(this.lead,e.proxy,e.target,o*.8),e.radius>0&&(this.rope.visible=!1),this.mark.visible=e.pointed,this.mark.position.copy(e.target),this.mark.quaternion.copy(t),this.mark.scale.setScalar(n*.045),this.shaft.visible=this.head.visible=r>.01&&!e.pointed,!this.shaft.visible)return;$o.copy(e.force).divideScalar(s);let a=n*(this.arrow.least+(this.arrow.longest-this.arrow.least)*r),l=Math.min(.09*n,.6*a),c=e.radius>0?e.proxy:e.place;this.tip.copy(c).addScaledVector($o,a),this.neck.copy(c).addScaledVector($o,a-l);let[h,u]=[this.tip,this.neck];jh(this.shaft,c,u,.145*l),jh(this.head,u,h,.4*l)}dispose(){for(let e of[this.skin,this.cord,this.glass,...this.hidden.values()])e.dispose()}};var BT=new V(0,0,1),mv=1-1e-6,zT=6,VT=300;function gv({normal:i}){return new V(...i).normalize()}function yv(i){let e=i.flatMap(t=>t.kind==="plane"&&gv(t).z>mv?[t.point[2]]:[]);return e.length?Math.max(...e):null}function vv(i,e,t,n){let s=e.flatMap(o=>{if(o.kind!=="box"||t.distanceTo(new V(...o.centre))>zT*n)return[];let a=xv(o);return Array.from({length:8},(l,c)=>new V(...o.size.map((u,d)=>(c>>d&1?.5:-.5)*u)).applyQuaternion(a).add(new V(...o.centre)).toArray()).flat()}),r=3*Math.max(1,Math.ceil(i.length/3/VT));return s.length?Float32Array.from([...s,...i.filter((o,a)=>a%r<3)]):i}function xv({turn:i}){let e=new V(...i);return new Gn().setFromAxisAngle(e.clone().normalize(),e.length())}var eu=class{group=new Qn;solid=Ns("#ffffff");sheet=Ns("#ffffff",.3);line=new Po({transparent:!0,opacity:.5});made=[];constructor(e,t,n){this.sheet.side=2;for(let s of e){if(s.kind==="plane"){let o=gv(s);if(o.z>mv)continue;let a=new Kt(this.keep(new Rs(5*n,5*n)),this.sheet);a.position.copy(t).addScaledVector(o,new V(...s.point).sub(t).dot(o)),a.quaternion.setFromUnitVectors(BT,o),a.renderOrder=-1,this.group.add(a);continue}let r=this.keep(new or(...s.size));for(let o of[new Kt(r,this.solid),new rr(this.keep(new Da(r)),this.line)])o.position.set(...s.centre),o.quaternion.copy(xv(s)),this.group.add(o)}}colours(e){Ds(this.solid,e?"#4A5464":"#CBD2DC"),Ds(this.sheet,e?"#8C98AA":"#7C8899"),this.line.color.set(e?"#9AA6B8":"#5C6878")}dispose(){for(let e of[this.solid,this.sheet,this.line,...this.made])e.dispose()}keep(e){return this.made.push(e),e}};var _v=900,bv=46,tu=matchMedia("(prefers-reduced-motion: reduce)");function Mv(i,e,t,n,s){return new Kf(i,e,t,n,s)}function GT(i){i.readPixels(0,0,1,1,i.RGBA,i.UNSIGNED_BYTE,new Uint8Array(4))}var Kf=class{constructor(e,t,n,s,r){this.scene=t;this.store=n;this.connection=s;this.stats=r;let o=t.radius||1,a=t.dimension<3;this.renderer=new Dh({antialias:!Ai(),alpha:!0,powerPreference:"high-performance"}),this.renderer.setClearAlpha(0),this.renderer.autoClear=!1,this.canvas=this.renderer.domElement,this.canvas.className="ct-canvas",this.canvas.tabIndex=0,this.canvas.setAttribute("role","application"),this.canvas.setAttribute("aria-label","The shared object. Drag it to pull; G grabs, arrows move, Escape lets go."),e.append(this.canvas),this.shape=new Wh(t),this.common=new qh(o,this.shape);let l=new V(...t.centre);this.orbit=new Kh(l,o,vv(t.points,t.obstacles,l,o),a),this.full=.6*t.stiffness*o,this.hold=new Jh(s,o,t.stiffness,a);for(let{slot:d}of t.users){let m=new $h(d,this.shape,this.common),g=new Qh(o,this.full,_i(d,!1));this.copies.set(d,m),this.hands.set(d,g),this.world.add(m.group,g.group)}let c=1/0;for(let d=2;d<t.points.length;d+=3)c=Math.min(c,t.points[d]);this.ground=new Yh(l,c,o,t.skin?this.mine.moving:null,yv(t.obstacles)),this.obstacles=new eu(t.obstacles,l,o),this.ground.mesh.visible=!a,this.dot=new Kt(new Ps(.022*o,20,14),this.dotPaint),this.dot.visible=!1,this.world.add(this.ground.mesh,this.obstacles.group,this.dot),this.labels=new Ka(e),this.furniture=new lo(e,n,{act:"Take hold of the object and pull. Drag beside it to look around.",look:"Drag to look around, and scroll to come nearer."}),this.touch=new Bh(this,n);let h=new ResizeObserver(()=>this.resize());h.observe(e);let u=()=>this.dress();this.ends.push(()=>h.disconnect(),qr(u),n.on("settings",u),n.on("slot",()=>{this.touch.release(),this.dress()}),n.on("frame",()=>this.draw()),n.on("state",()=>this.draw()),n.on("connection",()=>{n.connection==="open"&&this.hold.holds&&this.hold.send()})),this.resize(),this.dress()}scene;store;connection;stats;canvas;orbit;hold;renderer;world=new Cr;shape;common;copies=new Map;hands=new Map;ground;obstacles;dot;dotPaint=Ns("#ffffff");labels;furniture;touch;ends=[];full;face=new Gn;proxy=new V;place=new V;goal=new V;posed={place:new V,proxy:new V,target:new V,force:new V,radius:0,pointed:!1};fresh=!0;hovered=null;area=[];width=0;height=0;shown=null;dirty=!0;came=0;shadowed={by:-1,left:0};last=0;handle=0;peak=0;pulsed={slot:-1,since:-1/0};quality=new Vh(()=>Math.min(devicePixelRatio||1,2));reset(){this.orbit.reset(),this.draw()}pulse(e){this.pulsed={slot:e,since:performance.now()},this.draw()}spot(e){let t=this.area[0],n=e??this.pick(t.x+t.width/2,t.y+t.height/2,t.width)?.point;if(n===void 0)return null;let s=kh(this.orbit.camera,t,new V().fromArray(this.mine.moving.places,3*this.shape.corner[n]));return s&&{...s,point:n}}probe(){let e=this.canvas.getBoundingClientRect(),t=kh(this.orbit.camera,this.area[0],this.hold.target);return{space:this,hold:this.hold,orbit:this.orbit,target:t&&[t.x+e.left,t.y+e.top]}}dispose(){cancelAnimationFrame(this.handle),this.handle=-1,this.touch.dispose();for(let e of this.ends)e();for(let e of[...this.copies.values(),...this.hands.values(),this.ground,this.obstacles,this.dotPaint,this.dot.geometry,this.furniture])e.dispose();this.renderer.dispose(),this.renderer.forceContextLoss(),this.canvas.remove(),this.labels.element.remove()}ownCell(){return this.area[0]}cellAt(e,t){return this.area.find(n=>e>=n.x&&e<n.x+n.width&&t>=n.y&&t<n.y+n.height)??this.area[0]}pick(e,t,n){return this.cellAt(e,t)!==this.area[0]?null:Oh(this.mine.moving,this.orbit.camera,this.area[0],e,t,n)}aim(e,t){let n=this.canvas.getBoundingClientRect(),s=this.cellAt(e-n.left,t-n.top),r=(this.copies.get(s.slot)??this.mine).moving,o=Ho(this.orbit.camera,s,e-n.left,t-n.top),a=Oh(r,this.orbit.camera,s,e-n.left,t-n.top,0),l=a??Oh(r,this.orbit.camera,s,e-n.left,t-n.top,1/0);if(!l)return null;let c=this.orbit.camera.getWorldDirection(new V),h=a?.surface??o.at(l.place.clone().sub(o.origin).dot(c)/o.direction.dot(c),new V);return{point:l.point,to:[h.x,h.y,h.z]}}hover(e){e?.point!==this.hovered?.point&&this.draw(),this.hovered=e;let t=e?this.store.settings.tool:"";this.canvas.dataset.over!==t&&(this.canvas.dataset.over=t)}mayAct(){return this.connection.mayAct}force(){return Math.min(this.pull()/this.full,1)}draw(){this.dirty=!0,this.handle||(this.handle=requestAnimationFrame(e=>this.tick(e)))}get mine(){return this.copies.get(this.store.slot)??this.copies.values().next().value}get side(){return this.store.settings.layout==="side"}pull(){if(!this.hold.holds||this.fresh)return 0;let e=this.shown?.copies.find(t=>t.slot===this.store.slot);return this.hold.action==="ball"?e?.mode==="ball"?Math.hypot(...e.force):0:this.scene.stiffness*this.place.distanceTo(this.hold.target)}resize(){let e=this.canvas.parentElement?.getBoundingClientRect();!e||e.width<1||e.height<1||(this.width=Math.round(e.width),this.height=Math.round(e.height),this.renderer.setPixelRatio(this.quality.ratio),this.renderer.setSize(this.width,this.height),this.arrange(),this.shown&&this.render(performance.now()),this.draw())}arrange(){let e=this.scene.users.map(n=>n.slot).filter(n=>n!==this.store.slot),t=this.side&&this.height>3*bv?bv:0;this.area=pv([this.store.slot,...e],this.width,this.height-t,this.side);for(let n of this.area)n.y+=t;this.furniture.rules(this.area.length>1?this.area:[])}dress(){let{settings:e}=this.store,t=Vs(e.theme),n={displacement:0,stress:1,plain:2}[e.colour];n!==this.common.by.value&&(this.peak=0),this.common.by.value=n;for(let[s,r]of this.copies)r.paint(_i(s,t),t),r.against(this.mine.moving),this.hands.get(s).paint(_i(s,t));Ds(this.dotPaint,t?"#FFFFFF":"#111827"),this.ground.colours(t),this.obstacles.colours(t),this.arrange(),this.shown=null,this.draw()}tick(e){this.handle=0;let t=Math.min((e-this.last)/1e3,.1);this.last=e;let n=this.store.frame!==null&&this.store.frame!==this.shown,s=this.store.came-this.came-1;n&&(this.came=this.store.came,this.take(this.store.frame));let r=this.orbit.step(tu.matches?1:1-Math.exp(-t*18));r=this.touch.step(t)||r,r=this.haptic(t)||r,r=this.range(t)||r,r=e-this.pulsed.since<_v||r,(this.dirty||r)&&(this.dirty=!1,this.render(e),n&&(this.stats.finishing&&GT(this.renderer.getContext()),this.stats.drew(this.shown.echo,this.shown.received,performance.now()),this.quality.took(s,t)&&this.resize())),r&&this.draw()}take(e){this.shown=e,this.common.scale.value=e.scale;let t=this.side||this.store.settings.ghosts,n=this.common.by.value===1,s=0;for(let{slot:r,displacement:o}of e.copies){let a=this.copies.get(r);!a||!(t||a===this.mine)||(a.moving.update(o,e.scale,n&&(this.side||a===this.mine)),(this.side||a===this.mine)&&(s=Math.max(s,a.moving.peak)))}this.peak=Math.max(s,this.peak*.998)}haptic(e){if(!this.hold.holds)return!(this.fresh=!0);let{moving:t}=this.mine;if(this.hold.action==="grab")this.place.fromArray(t.places,3*this.shape.corner[this.hold.point]);else{let o=this.shown?.copies.find(a=>a.slot===this.store.slot);o?.mode==="ball"?this.place.fromArray(o.place):this.place.copy(this.hold.target)}let n=this.force(),s=this.hold.action==="ball"?1:.6*n/(n+.45),r=this.goal.lerpVectors(this.hold.target,this.place,s);return this.fresh||tu.matches?this.proxy.copy(r):this.proxy.lerp(r,1-Math.exp(-e*55)),this.fresh=!1,this.proxy.distanceTo(r)>1e-4*this.scene.radius}range(e){let t=this.common.by.value===1,n=ao(Math.max(this.peak,t?.02:.04*this.scene.radius));this.furniture.legend(this.store.settings.colour,t?`${Math.round(n*100)} %`:Nl(n));let{full:s}=this.common;return s.value+=(n-s.value)*(tu.matches?1:1-Math.exp(-e*6)),Math.abs(s.value-n)>.01*n}render(e){let{renderer:t,common:n}=this,[,,s]=this.orbit.axes();this.orbit.camera.getWorldQuaternion(this.face),t.setScissorTest(!1),t.setViewport(0,0,this.width,this.height),t.clear();for(let r of this.area){this.orbit.aspect(r.width,r.height);let o=this.copies.get(r.slot)??this.mine,a=this.shown?.copies;for(let[c,h]of this.copies){let u=!a||a.some(m=>m.slot===c),d=!this.side&&this.store.settings.ghosts&&u&&a;h.show(h===o?"solid":d?"ghost":"hidden",this.flash(c,e)),h.thin(this.mine.moving,this.orbit.camera.position,n.apart.value),h.order(s)}for(let[c,h]of this.hands)h.group.visible=(!this.side||c===r.slot)&&this.pose(c,h);this.dot.visible=!!this.hovered&&r===this.area[0],this.hovered&&this.dot.position.fromArray(this.mine.moving.places,3*this.shape.corner[this.hovered.point]),(this.side||o.slot!==this.shadowed.by||--this.shadowed.left<=0)&&(this.ground.shadow(t,o.moving,n.scale.value),this.shadowed={by:o.slot,left:this.quality.shadows}),n.height.value=r.height*this.quality.ratio;let l=this.height-r.y-r.height;t.setScissorTest(!0),t.setScissor(r.x,l,r.width,r.height),t.setViewport(r.x,l,r.width,r.height),t.render(this.world,this.orbit.camera),t.setScissorTest(!1),this.name(r)}this.orbit.aspect(this.area[0].width,this.area[0].height),this.labels.sweep()}flash(e,t){let n=(t-this.pulsed.since)/_v;return e!==this.pulsed.slot||n>=1||n<0?0:tu.matches?.6:Math.sin(n*Math.PI*3)**2*(1-n)}pose(e,t){let n=this.posed;if(e===this.store.slot&&this.hold.holds){let r=this.pull();return n.place.copy(this.place),n.proxy.copy(this.proxy),n.target.copy(this.hold.target),n.force.subVectors(n.target,n.place).setLength(r),n.radius=this.hold.action==="ball"?this.hold.radius:0,n.pointed=!0,t.pose(n,this.face),!0}let s=this.shown?.copies.find(r=>r.slot===e);return!s?.hasHand||s.mode==="free"||s.node<0&&s.radius===0?!1:(n.place.fromArray(s.place),n.target.fromArray(s.target),n.force.fromArray(s.force),n.proxy.copy(s.radius>0?n.place:n.target),n.radius=s.radius,n.pointed=!1,t.pose(n,this.face),!0)}name(e){let{slot:t,me:n,state:s}=this.store,r=o=>this.scene.users.find(a=>a.slot===o)?.name??`User ${o+1}`;if(this.side){let o=s?Ll(s,t).get(e.slot):0,a=this.shown?.copies.find(u=>u.slot===e.slot),l=s?.members[e.slot]?.here===!1||!a,c=a&&!a.direct?`, shown ${ss(a.age)} old`:"",h=e.slot===n?"you":e.slot===t?"":l?"not here":o===void 0?`out of reach${c}`:e.width<240?`+${ss(o)}`:n===null?`${ss(o)} after ${r(t)}${c}`:`feels you ${ss(o)} later${c}`;this.labels.put(`cell${e.slot}`,"title",e.slot,r(e.slot),h,e.x+14,e.y+12)}for(let[o,a]of this.hands){if(!a.group.visible)continue;let l=kh(this.orbit.camera,e,a.spot);if(!l||l.x<e.x||l.x>e.x+e.width||l.y<e.y||l.y>e.y+e.height)continue;let c=a.force>.005*this.full?Dl(a.force):"";if(this.side&&!c)continue;let h=this.side?"":o===n&&this.hold.holds?"You":r(o),u=Ka.wide(h,c);l.x=Math.max(Math.min(l.x,e.x+e.width-u),e.x);let d=this.side?0:this.furniture.covered(l.x,l.x+u,e.width);l.y=Math.max(Math.min(l.y,e.y+e.height+9-d),e.y+34),this.labels.put(`hand${o}`,"hand",o,h,c,l.x,l.y)}}};var HT="The picture needs WebGL 2, which this browser does not give; everything beside it works.";function Sv(i,e,t,n){let s=null,r="",o=()=>{let l=e.scene;if(!(!l||l.started===r)){r=l.started,s?.dispose(),s=null,i.classList.add("ct-stage");try{s=(l.dimension===1?lv:Mv)(i,l,e,t,n)}catch(c){i.replaceChildren(Object.assign(document.createElement("p"),{className:"ct-sorry",textContent:HT})),console.warn(c)}}},a=e.on("scene",o);return o(),{reset:()=>s?.reset(),probe:()=>s?.probe?.()??{},spot:l=>{let c=s?.spot(l),h=i.getBoundingClientRect();return c?{...c,x:c.x+h.left,y:c.y+h.top}:null},pulse:l=>s?.pulse(l),aim:(l,c)=>s?.aim(l,c)??null,dispose:()=>{a(),s?.dispose()}}}var nu=class{finishing=!1;frames=0;fps=0;dragToMesh=[];echoMs=[];waiting=[];since=0;counted=0;pointed(e,t){this.waiting.push({number:e,time:t}),this.waiting.length>600&&this.waiting.shift()}drew(e,t,n){for(this.frames++,this.counted++,n-this.since>=1e3&&(this.fps=this.counted*1e3/(n-this.since),this.since=n,this.counted=0);this.waiting.length&&this.waiting[0].number<=e;){let{time:s}=this.waiting.shift();wv(this.dragToMesh,n-s),wv(this.echoMs,t-s)}}};function wv(i,e){i.push(e),i.length>600&&i.shift()}var Ev=["x","y","z","force","energy","supplied","lost","linked"],iu=class{seconds=20;capacity=1240;count=0;version=0;next=0;times=new Float64Array(1240);tracks=new Map;get slots(){return[...this.tracks.keys()].sort((e,t)=>e-t)}clear(){this.count=this.next=0,this.tracks=new Map,this.version++}add(e){let t=this.next;if(this.count&&e.time<this.times[(t+1240-1)%1240])return;for(let s of this.tracks.values())for(let r of Ev)s[r][t]=NaN;let n=Math.max(1,Math.floor(e.points/1500));for(let s of e.copies){let r=this.track(s.slot),o=s.displacement,a=0,l=0,c=0,h=0;for(let d=0;d<e.points;d+=n,h++)a+=o[3*d],l+=o[3*d+1],c+=o[3*d+2];let u=e.scale/Math.max(h,1);r.x[t]=a*u,r.y[t]=l*u,r.z[t]=c*u,r.force[t]=Math.hypot(...s.force),r.energy[t]=s.energy,r.supplied[t]=s.supplied,r.lost[t]=s.lost,r.linked[t]=s.linked}this.times[t]=e.time,this.next=(t+1)%1240,this.count=Math.min(this.count+1,1240),this.version++}time(){return this.ordered(this.times,new Float64Array(this.count))}series(e,t){let n=this.tracks.get(t),s=new Float32Array(this.count);if(!n)return s.fill(NaN);if(e!=="displacement")return this.ordered(n[e],s);let[r,o,a]=["x","y","z"].map(l=>this.ordered(n[l],new Float32Array(this.count)));return s.map((l,c)=>Math.hypot(r[c],o[c],a[c]))}before(e,t){let n=this.tracks.get(e);if(!n||!this.count)return NaN;let s=l=>(this.next-1-l+2*1240)%1240,r=this.times[s(0)]-t,o=0,a=this.count-1;for(;o<a;){let l=o+a>>1;this.times[s(l)]>r?o=l+1:a=l}return n.x[s(o)]}ordered(e,t){let n=(this.next-this.count+1240)%1240,s=Math.min(this.count,1240-n);return t.set(e.subarray(n,n+s)),t.set(e.subarray(0,this.count-s),s),t}track(e){let t=this.tracks.get(e);return t||(t=Object.fromEntries(Ev.map(n=>[n,new Float32Array(1240).fill(NaN)])),this.tracks.set(e,t)),t}};var Tv={layout:"overlay",colour:"displacement",theme:"auto",tool:"grab",ghosts:!0},Av="cotouch.settings",WT=3;function XT(){try{return{...Tv,...JSON.parse(localStorage.getItem(Av)??"{}")}}catch{return{...Tv}}}var su=class{scene=null;state=null;frame=null;came=0;connection="connecting";refusal="";slot=0;history=new iu;settings=XT();listeners=new Map;wished;constructor(e=null){this.wished=e,e!==null&&(this.slot=e)}get stalled(){return this.connection==="open"&&!this.state?.ended&&(this.state?.age??0)>WT}get me(){return this.scene?.acts&&this.scene.own.includes(this.slot)?this.slot:null}get live(){return this.connection==="open"&&!this.state?.ended&&!this.stalled}on(e,t){let n=this.listeners.get(e)??new Set;return this.listeners.set(e,n.add(t)),()=>n.delete(t)}emit(e){for(let t of[...this.listeners.get(e)??[]])t()}set(e){this.settings={...this.settings,...e};try{localStorage.setItem(Av,JSON.stringify(this.settings))}catch{}this.emit("settings")}take(e){e!==this.slot&&(this.slot=this.wished=e,this.emit("slot"))}show(e){this.scene?.started!==e.started&&(this.state=this.frame=null,this.history.clear()),this.scene=e;let t=e.users.map(r=>r.slot),n=this.wished!==null&&t.includes(this.wished)?this.wished:e.own[0]??t[0]??0,s=n!==this.slot;this.slot=n,this.emit("scene"),s&&this.emit("slot")}told(e){this.state=e,this.emit("state")}drawn(e){this.frame=e,this.came++,this.history.add(e),this.emit("frame")}connected(e,t=""){e===this.connection&&t===this.refusal||(this.connection=e,this.refusal=t,this.emit("connection"))}};var qT=new URLSearchParams(location.search),jf=Number(qT.get("user")),$T=new URLSearchParams(location.hash.slice(1)).get("token")||null,Yo=new su(Number.isInteger(jf)&&jf>=1?jf-1:null),Qf=()=>_p(Yo.settings.theme);Qf();Yo.on("settings",Qf);qr(Qf);var ep=new nu,ru=new rl(Yo,$T,`${location.protocol==="https:"?"wss":"ws"}://${location.host}/ws`);ru.onPoint=(i,e)=>ep.pointed(i,e);var Cv=i0(document.getElementById("app"),Yo,ru),Rv=Sv(Cv.stageElement,Yo,ru,ep);Cv.attach(Rv);window.cotouch={store:Yo,connection:ru,stage:Rv,stats:ep};
